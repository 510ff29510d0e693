// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "check/kernel_code.hpp"

// The parts that every generated compute shader is made of.
namespace gloam::check::internal {

// The GLSL value of a scalar whose bits are in the uint expression `word`.
[[nodiscard]] std::string from_word(shader::Scalar scalar, const std::string& word);

// Everything in front of main(): the interface, the function's file, the definitions of its prototypes.
[[nodiscard]] std::string preamble(const KernelSource& source);

// The GLSL expression of an input scalar, given its position among the words of one input.
using InputText = std::function<std::string(shader::Scalar scalar, std::size_t word)>;

// Statements that call the function once and write what it returns from kernel_outputs[output_at] on.
struct Evaluation {
    std::string code;
    std::size_t input_words = 0;
    std::size_t output_words = 0;
};
[[nodiscard]] Evaluation evaluation(const shader::Function& function, const InputText& input);

// The head of main(), which knows `kernel_index` and `output_at` from there on and leaves invocations without
// an input, and its end, which writes the canary.
[[nodiscard]] std::string main_begin(std::size_t output_words);
[[nodiscard]] std::string main_end(std::size_t output_words);

}  // namespace gloam::check::internal
