// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "check/kernel_code.hpp"
#include "numeric/bounds.hpp"

// The kernels of OpenGL devices, before they are packed into one text of a version (shader/pack.hpp).
namespace gloam::check::internal {

// A compute shader with the buffers of KernelBinding. KernelRun is a uniform buffer.
inline constexpr unsigned gl_run_binding = 16;
[[nodiscard]] std::string gl_compute_text(const KernelSource& source);

// A fragment shader for versions without compute shaders. One fragment evaluates one input: that at the
// position y * gl_target_width + x. It reads words from textures (gl/word_texture.hpp), whose samplers are
// gloam_kernel_inputs and gloam_kernel_image0 ..., and writes a row of words: the outputs, the canary, and
// where there are images KernelFaults without its input. Its targets hold gl_target_words words each; a pass
// writes those from the position gloam_kernel_pass * targets * gl_target_words on.
inline constexpr std::size_t gl_target_width = 1024;
inline constexpr std::size_t gl_target_words = 4;
inline constexpr std::size_t gl_most_targets = 4;  // that every version has
// Throws Unsupported for a function that stores to images.
[[nodiscard]] std::string gl_fragment_text(const KernelSource& source);

// A fragment shader that evaluates one input and draws green where every output is allowed, else red: for
// scripts that run it elsewhere. Its inputs and images are arrays of uniforms, uint gloam_kernel_inputs[] and
// gloam_kernel_image0[] ...; what is allowed is part of the text. Throws as gl_fragment_text() does.
struct GlReplay {
    std::vector<std::size_t> image_words;  // of each image
    std::vector<shader::Scalar> outputs;
    std::vector<numeric::Bounds> allowed;  // of each output; none: nothing is known to be wrong
};
[[nodiscard]] std::string gl_replay_text(const KernelSource& source, const GlReplay& replay);

// Words of such a row.
[[nodiscard]] std::size_t gl_fragment_row(std::size_t output_words, std::size_t images);

}  // namespace gloam::check::internal
