// SPDX-License-Identifier: MIT
// Kernels whose inputs are constants of their text.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <functional>

#include "check/internal/kernel_text.hpp"
#include "check/kernel_code.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

// A decimal that denotes exactly this value. Its 17 digits identify it as a double.
std::string float_literal(Scalar scalar, double value) {
    std::string text = fmt::format("{:.17g}", value);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return scalar == Scalar::float16_ ? fmt::format("float16_t({})", text) : text;
}

// The expressions of the scalars of input `index`.
using InputOf = std::function<internal::InputText(std::size_t index)>;

std::string main_function(const KernelSource& source, std::size_t count, const InputOf& input_of) {
    internal::require_alone(source, "a kernel with constants");
    std::string cases;
    std::size_t output_words = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const internal::Evaluation evaluation = internal::evaluation(source, input_of(i));
        output_words = evaluation.output_words;
        cases += fmt::format("    case {}u: {{\n{}    break; }}\n", i, evaluation.code);
    }
    return internal::main_begin({}, output_words) + "    switch (gloam_kernel_index) {\n" + cases +
           "    }\n" + internal::main_end(output_words);
}

// Number of words in one input of the function.
std::size_t input_words(const KernelSource& source) {
    return internal::evaluation(source, [](Scalar, std::size_t) { return std::string(); }).input_words;
}

}  // namespace

std::string literal(Scalar scalar, Word word) {
    if (scalar == Scalar::bool_) return word != 0 ? "true" : "false";
    if (shader::is_float(scalar) && std::isfinite(number_at(scalar, word)))
        return float_literal(scalar, number_at(scalar, word));
    return internal::scalar_of_word(scalar, fmt::format("0x{:08x}u", word));
}

std::string literal_kernel_code(const KernelSource& source, std::span<const Word> inputs, std::size_t count) {
    const std::size_t words = count == 0 ? 0 : inputs.size() / count;
    const auto input_of = [&](std::size_t index) -> internal::InputText {
        return [input = inputs.subspan(index * words, words)](Scalar scalar, std::size_t word) {
            return literal(scalar, input[word]);
        };
    };
    return internal::kernel_text(source, main_function(source, count, input_of));
}

std::string specialized_kernel_code(const KernelSource& source, std::size_t count) {
    const std::size_t words = input_words(source);
    std::string constants;
    for (std::size_t id = 0; id < count * words; ++id)
        constants += fmt::format("layout(constant_id = {0}) const uint gloam_kernel_constant{0} = 0u;\n", id);
    const auto input_of = [words](std::size_t index) -> internal::InputText {
        return [first = index * words](Scalar scalar, std::size_t word) {
            return internal::scalar_of_word(scalar, fmt::format("gloam_kernel_constant{}", first + word));
        };
    };
    return internal::kernel_text(source, constants + main_function(source, count, input_of));
}

KernelCore internal::constant_kernel(const Lab& lab, const KernelSource& source, std::span<const Word> inputs,
                                     std::size_t count) {
    const bool literals = lab.options().variant.constants == shader::Variant::Constants::literals;
    const shader::Source text{.name = fmt::format("kernel of {} with {}", source.function.name,
                                                  literals ? "literals" : "specialization constants"),
                              .text = literals ? literal_kernel_code(source, inputs, count)
                                               : specialized_kernel_code(source, count)};
    KernelModule module = kernel_module(source, lab.compile_kernel(text, source.images));
    module.input_words = 0;
    module.fixed_inputs = count;
    for (std::size_t word = 0; !literals && word < inputs.size(); ++word)
        module.constants.push_back({.id = static_cast<std::uint32_t>(word), .bits = inputs[word]});
    lab.take_steps(module, text);
    return lab.core(std::move(module));
}

}  // namespace gloam::check
