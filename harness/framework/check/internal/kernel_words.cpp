// SPDX-License-Identifier: MIT
// How kernels make scalars of words, and words of scalars.
#include <fmt/format.h>
#include <set>

#include "check/internal/kernel_text.hpp"

namespace gloam::check::internal {
namespace {

using shader::Scalar;

std::string to_word(Scalar scalar, const std::string& value) {
    switch (scalar) {
        case Scalar::float16_:
            return fmt::format("floatBitsToUint(float({}))", value);
        case Scalar::int8_:
        case Scalar::int16_:
            return fmt::format("uint(int({}))", value);
        case Scalar::uint8_:
        case Scalar::uint16_:
            return fmt::format("uint({})", value);
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

}  // namespace

std::vector<std::string> to_words(Scalar scalar, const std::string& value) {
    if (scalar == Scalar::double_)
        return {fmt::format("unpackDouble2x32({}).x", value), fmt::format("unpackDouble2x32({}).y", value)};
    if (shader::bits_of(scalar) == 64)
        return {fmt::format("unpackUint2x32(uint64_t({})).x", value),
                fmt::format("unpackUint2x32(uint64_t({})).y", value)};
    return {to_word(scalar, value)};
}

std::string from_words(Scalar scalar, const WordText& text, std::size_t at) {
    const std::string word = text(at);
    switch (scalar) {
        case Scalar::double_:
            return fmt::format("packDouble2x32(uvec2({}, {}))", word, text(at + 1));
        case Scalar::int64_:
            return fmt::format("int64_t(packUint2x32(uvec2({}, {})))", word, text(at + 1));
        case Scalar::uint64_:
            return fmt::format("packUint2x32(uvec2({}, {}))", word, text(at + 1));
        case Scalar::int8_:
        case Scalar::int16_:
            return fmt::format("int{}_t(int({}))", shader::bits_of(scalar), word);
        case Scalar::uint8_:
        case Scalar::uint16_:
            return fmt::format("uint{}_t({})", shader::bits_of(scalar), word);
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
    std::set<Scalar> scalars;
    const auto add = [&scalars](const shader::Type& type) {
        const std::vector<Scalar> all = scalars_of(type);
        scalars.insert(all.begin(), all.end());
    };
    add(source.function.result);
    for (const shader::Parameter& parameter : source.function.parameters) add(parameter.type);
    for (const ImagePrototype& image : source.images) add(image.element);
    std::set<std::string> types;
    for (const Scalar scalar : scalars)
        if (shader::bits_of(scalar) != 32 && scalar != Scalar::double_)
            types.insert(
                fmt::format("{}{}", shader::is_float(scalar) ? "float" : "int", shader::bits_of(scalar)));
    std::string code;
    for (const std::string& type : types)
        code += fmt::format("#extension GL_EXT_shader_explicit_arithmetic_types_{} : require\n", type);
    return code;
}

}  // namespace gloam::check::internal
