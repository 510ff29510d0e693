// SPDX-License-Identifier: MIT
#include "numeric/internal/error_rule.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric::internal {
namespace {

// The ULP at a number that is known up to the error of double.
double own_ulp(const FloatFormat& format, double x) {
    return std::max(format.ulp(x * (1.0 - double_error)), format.ulp(x * (1.0 + double_error)));
}

// The largest error that a number beyond x (on the side away from zero) can have and still reach below x:
// above a power of two the ULP doubles.
double reaching_ulp(const FloatFormat& format, double x, double ulps) {
    return own_ulp(format, x * (1.0 + (ulps + 1.0) * std::ldexp(1.0, 2 - format.precision)));
}

double moved_out(double x, double distance) {
    return std::isinf(x) ? x : x + distance;
}

// The floats that lie within an error: none is beyond its end. A step of a formula is no float.
Interval floats_within(const Bounds& error) {
    const FloatFormat& format = Paths::format();
    Bounds inside{format.round_up(error.low), format.round_down(error.high), error.nan};
    if (Formula::runs() || inside.empty()) return enclose(error);
    // Where an error goes beyond the largest number, the result is that number or infinity.
    const double largest = format.largest();
    if (error.low < -largest) inside.low = -infinity;
    if (error.high > largest) inside.high = infinity;
    inside.low = std::min(inside.low, std::isinf(error.low) ? error.low : largest);
    inside.high = std::max(inside.high, std::isinf(error.high) ? error.high : -largest);
    const double normal = format.smallest_normal();
    if (inside.low > 0.0 && inside.low < normal) inside.low = 0.0;
    if (inside.high < 0.0 && inside.high > -normal) inside.high = 0.0;
    return Interval::within(inside);
}

}  // namespace

// The rounding error of the sum is known exactly (Knuth).
double sum_down(double a, double b) {
    const double sum = a + b;
    if (std::isnan(sum)) return infinity;  // infinities that cancel: not a number
    // Finite numbers beyond the largest double are above it.
    constexpr double largest = std::numeric_limits<double>::max();
    if (std::isinf(sum)) return sum < 0.0 || std::isinf(a) || std::isinf(b) ? sum : largest;
    const double part = sum - a;
    const double error = (a - (sum - part)) + (b - part);
    return error < 0.0 ? std::nextafter(sum, -infinity) : sum;
}

Bounds inflated(const Bounds& computed) {
    return {moved_out(computed.low, -std::abs(computed.low) * double_error),
            moved_out(computed.high, std::abs(computed.high) * double_error), computed.nan};
}

Interval within_ulps(const Bounds& computed, double ulps, Arguments arguments) {
    if (computed.empty()) return Interval::within(computed);
    const FloatFormat& format = Paths::format();
    // `inner`: the numbers next to this end lie further from zero than the end itself.
    const auto unit = [&](double x, bool inner) {
        if (std::isinf(x)) return 0.0;
        if (arguments != Arguments::range) return format.ulp(x);
        return inner ? reaching_ulp(format, x, ulps) : own_ulp(format, x);
    };
    const Bounds exact = arguments == Arguments::exact ? computed : inflated(computed);
    const double below = ulps * unit(computed.low, computed.low > 0.0);
    const double above = ulps * unit(computed.high, computed.high < 0.0);
    return floats_within({-sum_down(-exact.low, below), sum_down(exact.high, above), exact.nan});
}

Interval within_absolute(const Bounds& exact, double error, Ends ends) {
    if (exact.empty()) return Interval::within(exact);
    if (Formula::runs()) return enclose({exact.low - error, exact.high + error, exact.nan});
    Bounds all{-sum_down(-exact.low, error), sum_down(exact.high, error), exact.nan};
    if (ends == Ends::outside) {
        all.low = std::nextafter(all.low, infinity);
        all.high = std::nextafter(all.high, -infinity);
    }
    return floats_within(all);
}

}  // namespace gloam::numeric::internal

namespace gloam::numeric {

thread_local int Formula::depth_ = 0;

namespace {

bool contains_infinity(const Bounds& x) {
    return x.low == -infinity || x.high == infinity;
}

bool is_nowhere(const Bounds& a, const Bounds& b) {
    return a.empty() || b.empty();
}

// Adds the product (or quotient) at a corner. A corner that is not a number represents the values near it.
void add_corner(Bounds& all, double corner, bool beside_finite) {
    if (!std::isnan(corner)) {
        all = hull(all, Bounds::point(corner));
    } else if (beside_finite) {
        all = hull(all, Bounds::point(0.0));
    }
}

Bounds product(const Bounds& a, const Bounds& b) {
    constexpr Bounds nothing{infinity, -infinity, false};
    Bounds all = nothing;
    const bool wide = a.low != a.high || b.low != b.high;
    for (const double x : {a.low, a.high})
        for (const double y : {b.low, b.high}) add_corner(all, x * y, wide);
    const bool zero_times_infinity = (Bounds{a.low, a.high}.contains(0.0) && contains_infinity(b)) ||
                                     (Bounds{b.low, b.high}.contains(0.0) && contains_infinity(a));
    all.nan = a.nan || b.nan || zero_times_infinity;
    return all;
}

// Whether the rule of division covers every denominator: 2^-14 to 2^14 in float16, 2^-126 to 2^126 in
// float32.
bool is_divisor(const Bounds& y) {
    const double least = Paths::format().smallest_normal();
    const double most = 1.0 / least;
    return (y.low >= least && y.high <= most) || (y.high <= -least && y.low >= -most);
}

// x / 0 is infinite, of either sign, since the sign of a zero may be lost; no number between is permitted.
Interval over_zero(const Bounds& x, const Bounds& zero) {
    if (x.nan || x.contains(0.0)) return Interval::anything();
    const double infinite = std::copysign(infinity, x.low) * std::copysign(1.0, zero.low);
    const double chosen = Paths::choose(2) == 0 ? infinite : -infinite;
    return Interval::within(chosen, chosen);
}

constexpr double division_ulps = 2.5;

constexpr int most_integers = 64;

// The answer; both are explored if both are possible. NaN alone makes every comparison false.
bool decide(bool may_be_true, bool may_be_false) {
    if (may_be_true != may_be_false) return may_be_true;
    return Paths::choose(2) == 0;
}

// The answer for NaN or infinity that a device need not keep; empty if it must, or there are none.
std::optional<bool> answer_of_specials(const Interval& a, const Interval& b) {
    if (Paths::specials() == Paths::Specials::kept || !(is_special(a) || is_special(b))) return std::nullopt;
    return decide(true, true);
}

// The answer to a comparison, from what it may be for their numbers.
bool compared(const Interval& a, const Interval& b, bool may_be_true, bool may_be_false) {
    if (const auto answer = answer_of_specials(a, b)) return *answer;
    if (is_nowhere(a.bounds(), b.bounds())) return false;
    return decide(may_be_true, may_be_false || a.may_be_nan() || b.may_be_nan());
}

}  // namespace

Interval enclose(const Bounds& exact) {
    if (exact.empty()) return Interval::within(exact);
    const FloatFormat& format = Paths::format();
    Bounds bounds{format.round_down(exact.low), format.round_up(exact.high), exact.nan};
    if (Paths::rounding() == Paths::Rounding::to_even && format == float32)
        bounds = {static_cast<float>(exact.low), static_cast<float>(exact.high), exact.nan};
    const double normal = format.smallest_normal();
    if (exact.low > 0.0 && exact.low < normal) bounds.low = 0.0;
    if (exact.high < 0.0 && exact.high > -normal) bounds.high = 0.0;
    return Interval::within(bounds);
}

Interval::Interval(double constant) {
    if (std::isnan(constant)) {
        bounds_ = Bounds::only_nan();
    } else {
        bounds_ = enclose(Bounds::point(static_cast<float>(constant))).bounds();
    }
}

Interval Interval::converted(double integer) {
    return enclose(Bounds::point(integer));
}

Interval Interval::input(float value) {
    return std::isnan(value) ? Interval(Bounds::only_nan()) : enclose(Bounds::point(value));
}

Interval operator-(const Interval& x) {
    return Interval::within({-x.high(), -x.low(), x.may_be_nan()});
}

Interval operator+(const Interval& a, const Interval& b) {
    const Bounds& x = a.bounds();
    const Bounds& y = b.bounds();
    const bool cancels =
        (x.low == -infinity && y.high == infinity) || (x.high == infinity && y.low == -infinity);
    const bool nan = x.nan || y.nan || cancels;
    if (is_nowhere(x, y)) return Interval::within(Bounds::only_nan());
    return enclose({internal::sum_down(x.low, y.low), -internal::sum_down(-x.high, -y.high), nan});
}

Interval operator-(const Interval& a, const Interval& b) {
    return a + -b;
}

// The product of two values of a smaller format is exact in double.
Interval operator*(const Interval& a, const Interval& b) {
    if (is_nowhere(a.bounds(), b.bounds())) return Interval::within(Bounds::only_nan());
    return enclose(product(a.bounds(), b.bounds()));
}

Interval operator/(const Interval& a, const Interval& b) {
    const Bounds& x = a.bounds();
    const Bounds& y = b.bounds();
    if (is_nowhere(x, y)) return Interval::within(Bounds::only_nan());
    if (y.low == 0.0 && y.high == 0.0 && !y.nan) return over_zero(x, y);
    if (!is_divisor(y)) return Interval::anything();
    const std::array quotients{x.low / y.low, x.low / y.high, x.high / y.low, x.high / y.high};
    const auto [low, high] = std::ranges::minmax(quotients);
    const Bounds quotient{low, high, x.nan || y.nan};
    const bool exact = x.low == x.high && y.low == y.high && std::fma(low, y.low, -x.low) == 0.0;
    return internal::within_ulps(quotient, division_ulps,
                                 exact ? internal::Arguments::exact : internal::arguments_of(x, y));
}

Interval fma(const Interval& a, const Interval& b, const Interval& c) {
    const Paths::EitherWay either;
    return a * b + c;
}

bool is_special(const Interval& x) {
    const Bounds& b = x.bounds();
    return b.empty() || (b.low == b.high && std::isinf(b.low));
}

bool operator<(const Interval& a, const Interval& b) {
    return compared(a, b, a.low() < b.high(), a.high() >= b.low());
}

bool operator<=(const Interval& a, const Interval& b) {
    return compared(a, b, a.low() <= b.high(), a.high() > b.low());
}

bool operator==(const Interval& a, const Interval& b) {
    const bool meet = a.low() <= b.high() && b.low() <= a.high();
    const bool same = a.low() == a.high() && b.low() == b.high() && a.low() == b.low();
    return compared(a, b, meet, !same);
}

bool is_nan(const Interval& x) {
    if (const auto answer = answer_of_specials(x, x)) return *answer;
    return decide(x.may_be_nan(), !x.bounds().empty());
}

bool is_infinite(const Interval& x) {
    if (const auto answer = answer_of_specials(x, x)) return *answer;
    const bool infinite = !x.bounds().empty() && (x.low() == -infinity || x.high() == infinity);
    const bool finite = !x.bounds().empty() && (x.low() < infinity && x.high() > -infinity);
    return decide(infinite, finite || x.may_be_nan());
}

bool is_finite(const Interval& x) {
    const bool infinite = !x.bounds().empty() && (x.low() == -infinity || x.high() == infinity);
    const bool finite = !x.bounds().empty() && (x.low() < infinity && x.high() > -infinity);
    return decide(finite, infinite || x.may_be_nan());
}

double integer_within(const Interval& x, double least, double most) {
    const double low = std::trunc(x.low());
    const double high = std::trunc(x.high());
    if (x.may_be_nan() || !(low >= least && high <= most) || high - low >= most_integers)
        throw Paths::Undetermined{};
    const auto count = static_cast<std::size_t>(high - low) + 1;
    return low + static_cast<double>(Paths::choose(count));
}

std::uint32_t to_bits(const Interval& x) {
    if (x.may_be_nan() || x.bounds().empty()) throw Paths::Undetermined{};
    const std::int64_t low = ordinal_of(static_cast<float>(x.low()));
    const std::int64_t high = ordinal_of(static_cast<float>(x.high()));
    if (high - low >= most_integers) throw Paths::Undetermined{};
    const bool has_zero = low <= 0 && high >= 0;
    const auto count = static_cast<std::size_t>(high - low) + (has_zero ? 2U : 1U);
    const std::size_t chosen = Paths::choose(count);
    if (has_zero && chosen + 1 == count) return 0x80000000U;
    return std::bit_cast<std::uint32_t>(float_at(low + static_cast<std::int64_t>(chosen)));
}

}  // namespace gloam::numeric
