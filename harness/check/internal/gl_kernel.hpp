// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "check/internal/gl_kernel_text.hpp"
#include "check/kernel_core.hpp"
#include "gl/device.hpp"
#include "gl/draw.hpp"
#include "gl/program.hpp"
#include "shader/language.hpp"

namespace gloam::check::internal {

// The version of GLSL that kernels have on a version of OpenGL.
[[nodiscard]] shader::Language language_of(const gl::Version& version);

// The kernel of a function as one text for this version: its compute shader, else its fragment shader. Throws
// Unsupported.
[[nodiscard]] std::string gl_kernel_code(const gl::Version& version, const KernelSource& source,
                                         const std::vector<std::filesystem::path>& include_roots);

// The text of a replay as one text for this version. Throws Unsupported.
[[nodiscard]] std::string gl_replay_code(const gl::Version& version, const KernelSource& source,
                                         const GlReplay& replay,
                                         const std::vector<std::filesystem::path>& include_roots);

// A kernel on an OpenGL device.
class GlKernel {
  public:
    // Throws gl::CompileFailed, gl::LinkFailed.
    GlKernel(const gl::Device& device, std::shared_ptr<const KernelModule> module, std::string name);

    // As KernelCore::run().
    [[nodiscard]] KernelCore::Result run(std::span<const Word> inputs, std::size_t count,
                                         const ImageSet& images) const;

  private:
    struct Part;
    [[nodiscard]] std::size_t most_inputs() const;
    void run_compute(const Part& part, std::vector<std::vector<Word>>& images) const;
    void run_fragments(const Part& part, const std::vector<std::vector<Word>>& images) const;
    [[nodiscard]] std::vector<Word> rows_of(const gl::Draw& work, std::size_t count) const;

    const gl::Device& device_;
    std::shared_ptr<const KernelModule> module_;
    std::string name_;
    gl::Program program_;
};

}  // namespace gloam::check::internal
