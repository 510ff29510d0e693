// SPDX-License-Identifier: MIT
// How kernels make scalars of words, and words of scalars.
#include <fmt/format.h>
#include <algorithm>

#include "check/internal/kernel_text.hpp"

namespace gloam::check::internal {
using shader::Scalar;

std::string word_of_scalar(Scalar scalar, const std::string& value) {
    switch (scalar) {
        case Scalar::float16_:
            return fmt::format("floatBitsToUint(float({}))", value);
        case Scalar::float_:
            return fmt::format("floatBitsToUint({})", value);
        case Scalar::int_:
            return fmt::format("uint({})", value);
        case Scalar::bool_:
            return fmt::format("({} ? 1u : 0u)", value);
        default:
            return value;
    }
}

std::string scalar_of_word(Scalar scalar, const std::string& word) {
    switch (scalar) {
        case Scalar::float16_:
            return fmt::format("float16_t(uintBitsToFloat({}))", word);
        case Scalar::float_:
            return fmt::format("uintBitsToFloat({})", word);
        case Scalar::int_:
            return fmt::format("int({})", word);
        case Scalar::bool_:
            return fmt::format("({} != 0u)", word);
        default:
            return word;
    }
}

std::string number_extensions(const KernelSource& source) {
    std::vector<Scalar> scalars = scalars_of(source.function.result);
    for (const shader::Parameter& parameter : source.function.parameters)
        append_scalars(parameter.type, scalars);
    for (const ImagePrototype& image : source.images) append_scalars(image.element, scalars);
    return std::ranges::find(scalars, Scalar::float16_) == scalars.end()
               ? ""
               : "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n";
}

}  // namespace gloam::check::internal
