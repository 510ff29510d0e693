// SPDX-License-Identifier: MIT
#include "numeric/float_format.hpp"
#include "numeric/constants.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gloam::numeric {
namespace {

// Uses the hardware's float32, and corrects the result if it was rounded in the other direction.
double float32_down(double x) {
    const auto nearest = static_cast<float>(x);
    if (static_cast<double>(nearest) <= x) return nearest;
    if (nearest == 0.0F) return -std::numeric_limits<float>::denorm_min();
    const auto bits =
        std::bit_cast<std::uint32_t>(nearest);  // of the next number below: nearer to 0, or further
    return std::bit_cast<float>(nearest > 0.0F ? bits - 1 : bits + 1);
}

constexpr int double_digits = 52;  // of the significand, the hidden one not counted

// floor(log2 |x|) of a normal double; less than any format's smallest exponent for zero and subnormal
// doubles.
int exponent_of(double x) {
    constexpr int double_bias = 1023;
    constexpr std::uint64_t exponent_bits = 0x7ff;
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> double_digits & exponent_bits) - double_bias;
}

// The exponent of the last digit of the format's numbers near x.
int last_place(const FloatFormat& format, double x) {
    return std::max(exponent_of(x), format.min_exponent) - (format.precision - 1);
}

}  // namespace

double FloatFormat::round_down(double x) const {
    if (std::isinf(x) || x == 0.0) return x;
    if (*this == float32) return float32_down(x);
    if (x > largest()) return largest();
    if (x < -largest()) return -infinity;
    const int place = last_place(*this, x);
    const int exponent = exponent_of(x);
    if (exponent < place) return x > 0.0 ? 0.0 : -power_of_two(place);
    // Digits behind the last one are truncated; a negative number moves to the next one.
    const std::uint64_t digit = std::uint64_t{1} << (double_digits - (exponent - place));
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t cut = bits & ~(digit - 1);
    return std::bit_cast<double>(x < 0.0 && cut != bits ? cut + digit : cut);
}

double FloatFormat::round_up(double x) const {
    return -round_down(-x);
}

double FloatFormat::ulp(double x) const {
    const double magnitude = std::min(std::abs(x), largest());
    int place = last_place(*this, magnitude);
    const bool at_a_power_of_two =
        magnitude > smallest_normal() && magnitude == power_of_two(exponent_of(magnitude));
    return power_of_two(at_a_power_of_two ? place - 1 : place);
}

}  // namespace gloam::numeric
