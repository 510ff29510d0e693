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

// The whole shader: the interface, the function's file, the definitions of its prototypes, then `rest`, which
// has main(). Every name that is not the file's own begins with gloam_kernel_ or GloamKernel; no macro of the
// file reaches beyond its end.
[[nodiscard]] std::string kernel_text(const KernelSource& source, const std::string& rest);

// The GLSL expression of an input scalar, given its position among the words of one input.
using InputText = std::function<std::string(shader::Scalar scalar, std::size_t word)>;

// Statements that call the function once and write what it returns to the outputs, from
// gloam_kernel_output_at on.
struct Evaluation {
    std::string code;
    std::size_t input_words = 0;
    std::size_t output_words = 0;
};
[[nodiscard]] Evaluation evaluation(const shader::Function& function, const InputText& input);

// The head of main(), which knows `gloam_kernel_index` and `gloam_kernel_output_at` from there on and leaves
// invocations without an input, and its end, which writes the canary.
[[nodiscard]] std::string main_begin(std::size_t output_words);
[[nodiscard]] std::string main_end(std::size_t output_words);

}  // namespace gloam::check::internal
