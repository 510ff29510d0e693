// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace gloam::numeric {

// A binary floating-point format, described by the numbers that determine its rounding. Values are stored in
// double, which represents all values of these formats exactly.
struct FloatFormat {
    int precision;     // bits of the significand, the hidden one included
    int min_exponent;  // of the smallest normal number, 2^min_exponent
    int max_exponent;  // of the binade of the largest number

    [[nodiscard]] constexpr double smallest_normal() const { return power_of_two(min_exponent); }
    [[nodiscard]] constexpr double smallest_subnormal() const {
        return power_of_two(min_exponent - (precision - 1));
    }
    [[nodiscard]] constexpr double largest() const {
        return (2.0 - power_of_two(1 - precision)) * power_of_two(max_exponent);
    }

    // The nearest value of the format at or below (above) x. Beyond the largest finite value the result is
    // that value towards zero, and infinity away from zero. Infinities are returned unchanged; x must not be
    // NaN.
    [[nodiscard]] double round_down(double x) const;
    [[nodiscard]] double round_up(double x) const;

    // One unit in the last place at the real number x, by Harrison's definition: the distance of the two
    // neighbours that enclose x. At a power of two it is the smaller gap; below the smallest normal number
    // the gap there; beyond the largest value the largest gap.
    [[nodiscard]] double ulp(double x) const;

    friend constexpr bool operator==(const FloatFormat&, const FloatFormat&) = default;

  private:
    // For the exponents of normal doubles; calls of the C library would cost more than the rounding itself.
    static constexpr double power_of_two(int exponent) {
        constexpr int double_bias = 1023;
        constexpr int double_digits = 52;
        return std::bit_cast<double>(static_cast<std::uint64_t>(double_bias + exponent) << double_digits);
    }
};

inline constexpr FloatFormat float32{.precision = 24, .min_exponent = -126, .max_exponent = 127};
inline constexpr FloatFormat float16{.precision = 11, .min_exponent = -14, .max_exponent = 15};

}  // namespace gloam::numeric
