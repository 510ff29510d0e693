// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "check/kernel_code.hpp"

namespace gloam::check {

// The GLSL literal of a scalar with these bits, exactly: finite floats as decimals, others by
// uintBitsToFloat().
[[nodiscard]] std::string literal(shader::Scalar scalar, Word word);

// The text of a compute shader like that of kernel_code(), but with the inputs as literals in the text:
// invocation i evaluates input i. inputs: each of the same number of words, one after another.
[[nodiscard]] std::string literal_kernel_code(const KernelSource& source, std::span<const Word> inputs,
                                              std::size_t count);

// The same with `count` inputs as specialization constants of type uint: word w of input i has the
// constant_id i x (words of an input) + w.
[[nodiscard]] std::string specialized_kernel_code(const KernelSource& source, std::size_t count);

}  // namespace gloam::check
