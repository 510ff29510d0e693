// SPDX-License-Identifier: MIT
#include "subject/scalars.hpp"

#include <fmt/format.h>
#include <cmath>
#include <limits>

#include "subject/values_in_words.hpp"

namespace gloam::check {

using shader::Scalar;

void append_scalars(const shader::Type& type, std::vector<Scalar>& scalars) {
    if (type.scalar == Scalar::void_ || type.scalar == Scalar::sampler) return;
    if (!type.sizes.empty()) {
        const std::vector<Scalar> element = scalars_of(shader::element_of(type));
        for (std::uint32_t i = 0; i < type.sizes.front(); ++i)
            scalars.insert(scalars.end(), element.begin(), element.end());
        return;
    }
    if (type.scalar == Scalar::structure) {
        for (const shader::Member& member : type.members) append_scalars(member.type, scalars);
        return;
    }
    scalars.insert(scalars.end(), static_cast<std::size_t>(type.columns * type.rows), type.scalar);
}

std::vector<Scalar> scalars_of(const shader::Type& type) {
    std::vector<Scalar> scalars;
    append_scalars(type, scalars);
    return scalars;
}

double whole_number(Scalar scalar, Word word) {
    return scalar == Scalar::int_ ? from_word<int>(word) : static_cast<double>(word);
}

double number_at(Scalar scalar, Word word) {
    return shader::is_float(scalar) ? from_word<double>(word) : whole_number(scalar, word);
}

const numeric::FloatFormat& format_of(Scalar scalar) {
    return scalar == Scalar::float16_ ? numeric::float16 : numeric::float32;
}

Word float_word(Scalar scalar, double value) {
    if (scalar == Scalar::float16_ && std::isfinite(value)) {
        const double low = numeric::float16.round_down(value);
        const double high = numeric::float16.round_up(value);
        value = value - low <= high - value ? low : high;
    }
    return to_word(static_cast<float>(value));
}

Word stepped_float(Scalar scalar, Word word, std::int64_t steps) {
    if (scalar == Scalar::float_)
        return to_word(numeric::step(from_word<float>(word), static_cast<int>(steps)));
    const auto value = from_word<double>(word);
    if (!std::isfinite(value)) return word;
    // At a power of two the numbers above stand twice as far apart as those below.
    const double infinity = std::numeric_limits<double>::infinity();
    const double within = std::nextafter(value, steps < 0 ? -infinity : infinity);
    return float_word(scalar, value + static_cast<double>(steps) * numeric::float16.ulp(within));
}

bool same_bits(std::span<const Scalar> scalars, std::span<const Word> a, std::span<const Word> b) {
    const auto is_nan = [](Word word) { return std::isnan(from_word<float>(word)); };
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i] && !(shader::is_float(scalars[i]) && is_nan(a[i]) && is_nan(b[i]))) return false;
    return true;
}

std::string text_of(Scalar scalar, Word word) {
    if (shader::is_float(scalar)) return numeric::to_text(from_word<float>(word));
    if (scalar == Scalar::int_) return fmt::format("{}", from_word<int>(word));
    if (scalar == Scalar::bool_) return word != 0U ? "true" : "false";
    return fmt::format("{0} (0x{0:08x})", word);
}

}  // namespace gloam::check
