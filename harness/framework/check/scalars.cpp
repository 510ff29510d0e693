// SPDX-License-Identifier: MIT
#include "check/scalars.hpp"

#include <fmt/format.h>
#include <bit>
#include <cmath>

#include "check/values_in_words.hpp"

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
    for (int i = 0; i < type.columns * type.rows; ++i) {
        scalars.push_back(type.scalar);
        if (word_count(type.scalar) == 2) scalars.push_back(Scalar::upper);
    }
}

std::vector<Scalar> scalars_of(const shader::Type& type) {
    std::vector<Scalar> scalars;
    append_scalars(type, scalars);
    return scalars;
}

std::uint64_t bits_at(Scalar scalar, std::span<const Word> words) {
    return word_count(scalar) == 2 ? std::uint64_t{words[1]} << 32U | words[0] : words[0];
}

void set_bits(Scalar scalar, std::uint64_t bits, std::span<Word> words) {
    if (!shader::is_float(scalar) && shader::bits_of(scalar) < 32) {
        const unsigned unused = 64 - shader::bits_of(scalar);
        const std::uint64_t cut = bits << unused;
        bits = shader::is_signed(scalar)
                   ? static_cast<std::uint64_t>(static_cast<std::int64_t>(cut) >> unused)
                   : cut >> unused;
    }
    words[0] = static_cast<Word>(bits);
    if (word_count(scalar) == 2) words[1] = static_cast<Word>(bits >> 32U);
}

double float_at(Scalar scalar, std::span<const Word> words) {
    return scalar == Scalar::double_ ? std::bit_cast<double>(bits_at(scalar, words))
                                     : static_cast<double>(from_word<float>(words[0]));
}

bool is_rest_of_float(std::span<const Scalar> scalars, std::size_t word) {
    return scalars[word] == Scalar::upper && scalars[word - 1] == Scalar::double_;
}

double whole_number(std::span<const Scalar> scalars, Word bits, std::size_t word) {
    if (is_rest_of_float(scalars, word)) return 0.0;
    const Scalar scalar = scalars[word] == Scalar::upper ? scalars[word - 1] : scalars[word];
    const bool low_word = scalars[word] == Scalar::int64_;
    return shader::is_signed(scalar) && !low_word ? from_word<int>(bits) : static_cast<double>(bits);
}

double number_at(std::span<const Scalar> scalars, std::span<const Word> words, std::size_t word) {
    return shader::is_float(scalars[word]) ? float_at(scalars[word], words.subspan(word))
                                           : whole_number(scalars, words[word], word);
}

const numeric::FloatFormat& format_of(Scalar scalar) {
    if (scalar == Scalar::double_) return numeric::float64;
    return scalar == Scalar::float16_ ? numeric::float16 : numeric::float32;
}

void set_float(Scalar scalar, double value, std::span<Word> words) {
    if (scalar == Scalar::double_) return set_bits(scalar, std::bit_cast<std::uint64_t>(value), words);
    if (scalar == Scalar::float16_ && std::isfinite(value)) {
        const double low = numeric::float16.round_down(value);
        const double high = numeric::float16.round_up(value);
        value = value - low <= high - value ? low : high;
    }
    words[0] = to_word(static_cast<float>(value));
}

void append_float(Scalar scalar, double value, std::vector<Word>& words) {
    words.resize(words.size() + word_count(scalar));
    set_float(scalar, value, std::span(words).last(word_count(scalar)));
}

void step_float(Scalar scalar, std::int64_t steps, std::span<Word> words) {
    const double value = float_at(scalar, words);
    if (scalar == Scalar::double_) return set_float(scalar, numeric::step(value, steps), words);
    if (scalar == Scalar::float_) {
        words[0] = to_word(numeric::step(from_word<float>(words[0]), static_cast<int>(steps)));
    } else if (std::isfinite(value)) {
        set_float(scalar, value + static_cast<double>(steps) * numeric::float16.ulp(value), words);
    }
}

bool same_bits(std::span<const Scalar> scalars, std::span<const Word> a, std::span<const Word> b) {
    const auto is_nan = [&](std::span<const Word> words, std::size_t i) {
        return shader::is_float(scalars[i]) && std::isnan(float_at(scalars[i], words.subspan(i)));
    };
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] == b[i]) continue;
        const std::size_t first = is_rest_of_float(scalars, i) ? i - 1 : i;
        if (!is_nan(a, first) || !is_nan(b, first)) return false;
    }
    return true;
}

std::string text_at(Scalar scalar, std::span<const Word> words) {
    switch (scalar) {
        case Scalar::float_:
        case Scalar::float16_:
            return numeric::to_text(from_word<float>(words[0]));
        case Scalar::double_:
            return fmt::format("{} (0x{:016x})", float_at(scalar, words), bits_at(scalar, words));
        case Scalar::int_:
        case Scalar::int8_:
        case Scalar::int16_:
            return fmt::format("{}", from_word<int>(words[0]));
        case Scalar::bool_:
            return words[0] != 0U ? "true" : "false";
        case Scalar::int64_:
            return fmt::format("{}", static_cast<std::int64_t>(bits_at(scalar, words)));
        case Scalar::uint64_:
            return fmt::format("{0} (0x{0:016x})", bits_at(scalar, words));
        default:
            return fmt::format("{0} (0x{0:08x})", words[0]);
    }
}

}  // namespace gloam::check
