// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gloam::numeric {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest_float = std::numeric_limits<float>::max();

// A binary floating-point format, at most that of double, described by the numbers that determine its
// rounding. Values are stored in double.
struct FloatFormat {
    int precision;     // bits of the significand, the hidden one included
    int min_exponent;  // of the smallest normal number, 2^min_exponent
    int max_exponent;  // of the binade of the largest number

    [[nodiscard]] constexpr double smallest_normal() const { return power_of_two(min_exponent); }
    [[nodiscard]] constexpr double smallest_subnormal() const {
        return power_of_two(min_exponent) * power_of_two(1 - precision);
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

// Classes of values that arithmetic treats differently. `huge`: the square overflows (float32: |x| >= 2^64).
enum class FloatClass { ordinary, zero, subnormal, huge, infinite, nan };

[[nodiscard]] FloatClass classify(double x, const FloatFormat& format = float32);

// Values at which arithmetic behaves differently: signed zeros, the ends of the subnormal and normal ranges,
// ones, the limit of exact integers, squares that overflow or underflow, infinities, NaN.
[[nodiscard]] std::vector<double> special_values(const FloatFormat& format);

// Distance of `got` from the exact result `want`, in ULP of `want` in a format.
//   both NaN, or the same infinity: 0. Exactly one NaN: infinity. Infinity against a finite `want`: infinity,
//   unless |want| exceeds the format's largest, where both that value and infinity of the right sign are
//   exact. A `want` below the smallest normal also accepts 0, because Vulkan lets subnormal results be
//   flushed.
[[nodiscard]] double ulp_error(double got, double want, const FloatFormat& format = float32);

// |got - want| with the same special cases: 0 where ulp_error is 0, infinity where it is infinity.
[[nodiscard]] double absolute_error(double got, double want, const FloatFormat& format = float32);

// The float32 values counted from zero: -1 is the largest below it; +0 and -0 are one value. x is not NaN.
[[nodiscard]] std::int64_t ordinal_of(float x);
[[nodiscard]] float float_at(std::int64_t ordinal);

// The float32 `steps` representable values above x (below, when negative), crossing zero once (+0 and -0 are
// one value), stopping at +-infinity. NaN stays NaN.
[[nodiscard]] float step(float x, int steps);

// Shortest decimal that is read as the same value, and the exact bits: "0.1 (0x3dcccccd)".
[[nodiscard]] std::string to_text(float x);
// Decimal with 9 significant digits, and the exact hexadecimal value: "0.1 (0x1.999999999999ap-4)".
[[nodiscard]] std::string to_text(double x);

// A fraction of what is allowed, or another number near 1: two digits behind the point, at most six in front
// of it: "0.68", "1.5e+41".
[[nodiscard]] std::string to_short_text(double x);

// A median with its quartiles. NaN without values.
struct Spread {
    double median = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();   // lower quartile
    double high = std::numeric_limits<double>::quiet_NaN();  // upper quartile
};

// Median and quartiles, interpolated linearly between the values of the sorted list; the first value is the
// quantile 0, the last the quantile 1. Values that are not finite are skipped.
[[nodiscard]] Spread spread_of(std::span<const double> values);

}  // namespace gloam::numeric
