// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "shader/cache.hpp"

namespace gloam::scene {

// The passes of glsl/passes, compiled when asked for.
class PassLibrary {
  public:
    // glsl: the folder that holds gloam/ and passes/. cache: where compiled passes are kept; empty: nowhere.
    // optimization: of every pass.
    explicit PassLibrary(std::filesystem::path glsl, const std::filesystem::path& cache = {},
                         shader::Optimization optimization = shader::Optimization::hoisting);

    // The same passes, optimised otherwise.
    [[nodiscard]] PassLibrary with(shader::Optimization optimization) const;

    // An #include of a pass, as written, and what is included instead.
    struct Replacement {
        std::string include;
        std::string instead;
    };

    // The pass in passes/NAME, whose suffix (.comp, .vert, .frag) says its stage. Each
    // of `defines` is defined before the first line. Throws std::runtime_error for a missing file,
    // std::invalid_argument for a replacement of what the pass does not include, shader::CompileError for a
    // pass that does not compile.
    [[nodiscard]] shader::Spirv compile(const std::string& name, const std::vector<std::string>& defines = {},
                                        const std::vector<Replacement>& replacements = {}) const;

    // The same pass as one text without #include and #if, its constants set (shader::pack()). Throws like
    // compile().
    [[nodiscard]] std::string text(const std::string& name, const std::vector<std::string>& defines = {},
                                   const std::vector<Replacement>& replacements = {},
                                   const std::map<std::uint32_t, std::uint32_t>& constants = {}) const;

  private:
    [[nodiscard]] shader::Source source(const std::string& name, const std::vector<std::string>& defines,
                                        const std::vector<Replacement>& replacements) const;

    std::filesystem::path glsl_;
    shader::SpirvCache cache_;
    shader::Optimization optimization_;
};

}  // namespace gloam::scene
