// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "module/compile.hpp"

namespace gloam::scene {

// How passes read images that they do not write (passes/study/input_image.glsl): as sampled images or as
// storage images. by_device: as storage images on drivers that run on the CPU, which read these in less time.
enum class Inputs { by_device, sampled, storage };

// The passes of glsl/passes, compiled on demand.
class PassLibrary {
  public:
    // An #include of a pass, as written, and its replacement.
    struct Replacement {
        std::string include;
        std::string instead;
    };

    // glsl: the folder that contains gloam/ and passes/. cache: folder for compiled passes; empty: no cache.
    explicit PassLibrary(std::filesystem::path glsl, const std::filesystem::path& cache = {});

    Inputs inputs = Inputs::by_device;  // where pipelines are made of the passes

    // The same passes with another optimization than module::Optimization::hoisting.
    [[nodiscard]] PassLibrary with(module::Optimization optimization) const;

    // The same passes; where loop invariants are hoisted, drivers are asked to unroll the loops as well.
    [[nodiscard]] PassLibrary unrolled() const;

    // Compiles the pass passes/NAME, whose suffix determines the stage. `defines` are defined before the
    // first line. Throws std::runtime_error for a missing file, std::invalid_argument for a replacement of a
    // file that the pass does not include, source::CompileError for a pass that does not compile.
    [[nodiscard]] module::Spirv compile(const std::string& name, const std::vector<std::string>& defines = {},
                                        const std::vector<Replacement>& replacements = {}) const;

    // The same pass as one text of this version without #include and #if, with its constants set
    // (module::pack()). Throws like compile().
    [[nodiscard]] std::string text(const std::string& name, const std::vector<std::string>& defines = {},
                                   const std::vector<Replacement>& replacements = {},
                                   const std::map<std::uint32_t, std::uint32_t>& constants = {},
                                   source::Language language = source::Language::vulkan450) const;

  private:
    [[nodiscard]] source::Source source(const std::string& name,
                                        const std::vector<Replacement>& replacements) const;

    std::filesystem::path glsl_;
    module::SpirvCache cache_;
    module::Optimization optimization_ = module::Optimization::hoisting;
};

}  // namespace gloam::scene
