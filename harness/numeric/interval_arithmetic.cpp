// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "numeric/constants.hpp"
#include "numeric/internal/error_rule.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

// a + b rounded towards -infinity in double; the rounding error of the sum is known exactly (Knuth).
double sum_down(double a, double b) {
    const double sum = a + b;
    if (std::isnan(sum)) return infinity;  // infinities that cancel: not a number
    if (std::isinf(sum)) return sum;
    const double part = sum - a;
    const double error = (a - (sum - part)) + (b - part);
    return error < 0.0 ? std::nextafter(sum, -infinity) : sum;
}

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
    for (const double x : {a.low, a.high}) {
        for (const double y : {b.low, b.high}) add_corner(all, x * y, wide);
    }
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

// x / 0 is infinite, of either sign, since the sign of a zero may be lost.
Interval over_zero(const Bounds& x) {
    return Interval::within({-infinity, infinity, x.nan || x.contains(0.0)});
}

constexpr double division_ulps = 2.5;

}  // namespace

Interval enclose(const Bounds& exact) {
    if (exact.empty()) return Interval::within(exact);
    const FloatFormat& format = Paths::format();
    Bounds bounds{format.round_down(exact.low), format.round_up(exact.high), exact.nan};
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

Interval operator+(const Interval& x) {
    return x;
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
    return enclose({sum_down(x.low, y.low), -sum_down(-x.high, -y.high), nan});
}

Interval operator-(const Interval& a, const Interval& b) {
    return a + -b;
}

// The product of two values of the format is exact in double.
Interval operator*(const Interval& a, const Interval& b) {
    if (is_nowhere(a.bounds(), b.bounds())) return Interval::within(Bounds::only_nan());
    return enclose(product(a.bounds(), b.bounds()));
}

Interval operator/(const Interval& a, const Interval& b) {
    const Bounds& x = a.bounds();
    const Bounds& y = b.bounds();
    if (is_nowhere(x, y)) return Interval::within(Bounds::only_nan());
    if (y.low == 0.0 && y.high == 0.0 && !y.nan) return over_zero(x);
    if (!is_divisor(y)) return Interval::anything();
    const std::array quotients{x.low / y.low, x.low / y.high, x.high / y.low, x.high / y.high};
    const auto [low, high] = std::ranges::minmax(quotients);
    const Bounds quotient{low, high, x.nan || y.nan};
    const bool exact = x.low == x.high && y.low == y.high && std::fma(low, y.low, -x.low) == 0.0;
    if (exact) return internal::within_ulps(quotient, division_ulps, internal::Arguments::exact);
    return internal::within_ulps(internal::inflated(quotient), division_ulps, internal::arguments_of(x, y));
}

Interval fma(const Interval& a, const Interval& b, const Interval& c) {
    return a * b + c;
}

Interval& Interval::operator+=(const Interval& b) {
    return *this = *this + b;
}
Interval& Interval::operator-=(const Interval& b) {
    return *this = *this - b;
}
Interval& Interval::operator*=(const Interval& b) {
    return *this = *this * b;
}
Interval& Interval::operator/=(const Interval& b) {
    return *this = *this / b;
}

}  // namespace gloam::numeric
