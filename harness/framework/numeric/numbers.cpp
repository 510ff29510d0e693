// SPDX-License-Identifier: MIT
#include "numeric/numbers.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>
#include <vector>

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

// 0 or infinity if the error is not a matter of distance; -1 if it is.
double settled_error(double got, double want, const FloatFormat& format) {
    if (std::isnan(got) || std::isnan(want)) return std::isnan(got) && std::isnan(want) ? 0.0 : infinity;
    if (std::abs(want) > format.largest()) {
        const bool same_side = std::signbit(got) == std::signbit(want);
        const bool exact =
            same_side && (std::isinf(got) || (!std::isinf(want) && std::abs(got) >= format.largest()));
        return exact ? 0.0 : infinity;
    }
    if (std::isinf(got)) return infinity;
    if (std::abs(want) < format.smallest_normal() && got == 0.0) return 0.0;
    return -1.0;
}

double quantile(const std::vector<double>& sorted, double q) {
    const double at = q * static_cast<double>(sorted.size() - 1);
    const auto lower = static_cast<std::size_t>(at);
    const std::size_t upper = std::min(lower + 1, sorted.size() - 1);
    return std::lerp(sorted[lower], sorted[upper], at - static_cast<double>(lower));
}

}  // namespace

double FloatFormat::round_down(double x) const {
    if (std::isinf(x) || x == 0.0 || precision == double_digits + 1) return x;
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
    const bool at_a_power_of_two =
        magnitude > smallest_normal() && magnitude == power_of_two(exponent_of(magnitude));
    const int place = last_place(*this, magnitude) - (at_a_power_of_two ? 1 : 0);
    return power_of_two(place);
}

FloatClass classify(double x, const FloatFormat& format) {
    if (std::isnan(x)) return FloatClass::nan;
    if (std::isinf(x)) return FloatClass::infinite;
    if (x == 0.0) return FloatClass::zero;
    const double magnitude = std::abs(x);
    if (magnitude < format.smallest_normal()) return FloatClass::subnormal;
    return magnitude >= std::ldexp(1.0, (format.max_exponent + 1) / 2) ? FloatClass::huge
                                                                       : FloatClass::ordinary;
}

std::vector<double> special_values(const FloatFormat& format) {
    const int half_range = (format.max_exponent + 1) / 2;
    const double unit = std::ldexp(1.0, 1 - format.precision);
    return {0.0,
            -0.0,
            format.smallest_subnormal(),
            -format.smallest_subnormal(),
            format.smallest_normal() - format.smallest_subnormal(),
            format.smallest_normal(),
            -format.smallest_normal(),
            std::ldexp(1.0, -half_range),
            1.0 - unit / 2.0,
            1.0,
            1.0 + unit,
            -1.0,
            std::ldexp(1.0, format.precision),
            std::ldexp(1.0, half_range),
            format.largest(),
            -format.largest(),
            infinity,
            -infinity,
            std::numeric_limits<double>::quiet_NaN()};
}

double ulp_error(double got, double want, const FloatFormat& format) {
    const double settled = settled_error(got, want, format);
    return settled >= 0.0 ? settled : std::abs(got - want) / format.ulp(want);
}

double absolute_error(double got, double want, const FloatFormat& format) {
    const double settled = settled_error(got, want, format);
    return settled >= 0.0 ? settled : std::abs(got - want);
}

std::int64_t ordinal_of(float x) {
    const auto magnitude = std::int64_t{std::bit_cast<std::uint32_t>(x) & 0x7fffffffU};
    return std::signbit(x) ? -magnitude : magnitude;
}

float float_at(std::int64_t ordinal) {
    const auto magnitude = std::bit_cast<float>(static_cast<std::uint32_t>(std::abs(ordinal)));
    return ordinal < 0 ? -magnitude : magnitude;
}

float step(float x, int steps) {
    if (std::isnan(x)) return x;
    const std::int64_t last = ordinal_of(std::numeric_limits<float>::infinity());
    return float_at(std::clamp(ordinal_of(x) + steps, -last, last));
}

std::string to_text(float x) {
    return fmt::format("{} (0x{:08x})", x, std::bit_cast<std::uint32_t>(x));
}

std::string to_text(double x) {
    // Versions of fmt write the hexadecimal 0 differently.
    if (x == 0.0) return std::signbit(x) ? "-0 (-0x0p+0)" : "0 (0x0p+0)";
    return fmt::format("{:.9g} ({:a})", x, x);
}

std::string to_short_text(double x) {
    constexpr double most = 1e6;
    return x > -most && x < most ? fmt::format("{:.2f}", x) : fmt::format("{:.2g}", x);
}

Spread spread_of(std::span<const double> values) {
    std::vector<double> sorted;
    std::ranges::copy_if(values, std::back_inserter(sorted), [](double v) { return std::isfinite(v); });
    if (sorted.empty()) return {};
    std::ranges::sort(sorted);
    return {quantile(sorted, 0.5), quantile(sorted, 0.25), quantile(sorted, 0.75)};
}

}  // namespace gloam::numeric
