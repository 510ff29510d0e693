// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "check/internal/kernel_text.hpp"
#include "check/lab.hpp"
#include "gl/device.hpp"
#include "gl/program.hpp"
#include "shader/compile.hpp"

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

// How far the precision rules of OpenGL agree with those of Vulkan, by which the interpreter judges
// (docs/opengl-and-browsers.md).

// Whether the rules of this version of GLSL can be asked: GLSL 4.50 and GLSL ES 3.20, whose section 4.7.1 has
// the same table as Vulkan, and which know `precise`.
[[nodiscard]] bool has_precision_rules(shader::Language language);

// Whether the module calls a built-in whose precision section 4.7.1 leaves undefined: a trigonometric or
// hyperbolic function, determinant, inverse.
[[nodiscard]] bool calls_undefined_precision(const shader::Spirv& module);

}  // namespace gloam::check::internal
