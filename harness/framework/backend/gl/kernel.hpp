// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "backend/backend.hpp"

// The interface of a kernel's text (Device::make_kernel).
namespace gloam::backend::gl {

// A compute shader has the buffers of backend::KernelBinding, and backend::KernelRun as a uniform buffer:
inline constexpr unsigned kernel_run_binding = 16;

// A fragment shader, for versions without compute shaders, evaluates the input at the position
// y * kernel_target_width + x. It reads words from textures (backend/gl/resources.hpp), whose samplers are
// gloam_kernel_inputs and gloam_kernel_image0 ..., and writes a row of words: the outputs, the canary, and
// where there are images backend::KernelFaults without its input. Its targets hold kernel_target_words words
// each; a pass writes those from the position gloam_kernel_pass * targets * kernel_target_words on.
inline constexpr std::size_t kernel_target_width = 1024;
inline constexpr std::size_t kernel_target_words = 4;
inline constexpr std::size_t kernel_fault_words = sizeof(backend::KernelFaults) / sizeof(backend::Word) - 1;

// Words of such a row.
[[nodiscard]] constexpr std::size_t kernel_row(std::size_t output_words, std::size_t images) {
    return output_words + 1 + (images > 0 ? kernel_fault_words : 0);
}

// Targets of one pass that writes rows of so many words.
[[nodiscard]] constexpr std::size_t kernel_targets(std::size_t row) {
    constexpr std::size_t most = 4;  // that every version has
    return std::min((row + kernel_target_words - 1) / kernel_target_words, most);
}

}  // namespace gloam::backend::gl
