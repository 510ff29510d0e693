// SPDX-License-Identifier: MIT
#include "check/kernel_code.hpp"

#include <fmt/format.h>

#include "check/internal/kernel_text.hpp"

namespace gloam::check {

std::string kernel_code(const KernelSource& source) {
    const auto input = [](shader::Scalar scalar, std::size_t word) {
        return internal::from_word(scalar,
                                   fmt::format("gloam_kernel_inputs[gloam_kernel_input_at + {}u]", word));
    };
    const internal::Evaluation evaluation = internal::evaluation(source.function, input);
    return internal::kernel_text(
        source, internal::main_begin(evaluation.output_words) +
                    fmt::format("    uint gloam_kernel_input_at = gloam_kernel_index * {}u;\n",
                                evaluation.input_words) +
                    evaluation.code + internal::main_end(evaluation.output_words));
}

}  // namespace gloam::check
