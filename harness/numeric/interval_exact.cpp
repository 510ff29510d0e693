// SPDX-License-Identifier: MIT
// Functions whose results Vulkan requires to be correct or correctly rounded, and functions composed of
// these.
#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/internal/error_rule.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

using internal::monotonic;

template <class F>
Interval exactly(const Interval& x, F&& f) {
    if (x.bounds().empty()) return x;
    return Interval::within(monotonic(x.bounds(), f));
}

// min and max return either operand when one is NaN.
template <class F>
Interval chosen(const Interval& a, const Interval& b, F&& choose) {
    const Bounds& x = a.bounds();
    const Bounds& y = b.bounds();
    if (x.empty() || y.empty()) return Interval::within(hull(x, y));
    Bounds both{choose(x.low, y.low), choose(x.high, y.high), false};
    if (x.nan) both = hull(both, y);
    if (y.nan) both = hull(both, x);
    both.nan = x.nan || y.nan;
    return Interval::within(both);
}

}  // namespace

Interval abs(const Interval& x) {
    const Bounds& b = x.bounds();
    if (b.empty() || b.low >= 0.0) return x;
    if (b.high <= 0.0) return -x;
    return Interval::within({0.0, std::max(-b.low, b.high), b.nan});
}

Interval sign(const Interval& x) {
    if (x.may_be_nan()) return Interval::within({-1.0, 1.0, true});
    return exactly(x, [](double v) { return v > 0.0 ? 1.0 : (v < 0.0 ? -1.0 : 0.0); });
}

Interval min(const Interval& a, const Interval& b) {
    return chosen(a, b, [](double x, double y) { return std::min(x, y); });
}

Interval max(const Interval& a, const Interval& b) {
    return chosen(a, b, [](double x, double y) { return std::max(x, y); });
}

Interval clamp(const Interval& x, const Interval& low, const Interval& high) {
    if (!(low.high() <= high.low()) || low.may_be_nan() || high.may_be_nan()) return Interval::anything();
    return min(max(x, low), high);
}

Interval step(const Interval& edge, const Interval& x) {
    return x < edge ? Interval(0.0) : Interval(1.0);
}

Interval floor(const Interval& x) {
    return exactly(x, [](double v) { return std::floor(v); });
}

Interval ceil(const Interval& x) {
    return exactly(x, [](double v) { return std::ceil(v); });
}

Interval trunc(const Interval& x) {
    return exactly(x, [](double v) { return std::trunc(v); });
}

Interval round_even(const Interval& x) {
    return exactly(x, [](double v) { return std::nearbyint(v); });
}

Interval round(const Interval& x) {
    if (x.bounds().empty()) return x;
    return Interval::within({std::ceil(x.low() - 0.5), std::floor(x.high() + 0.5), x.may_be_nan()});
}

Interval fract(const Interval& x) {
    const Bounds& b = x.bounds();
    if (b.empty() || std::isinf(b.low) || std::isinf(b.high)) return Interval::within({0.0, 1.0, true});
    if (std::floor(b.low) != std::floor(b.high)) return Interval::within({0.0, 1.0, b.nan});
    return x - floor(x);
}

Interval mod(const Interval& x, const Interval& y) {
    return x - y * floor(x / y);
}

Interval remainder(const Interval& x, const Interval& y) {
    return x - y * trunc(x / y);
}

Interval mix(const Interval& a, const Interval& b, const Interval& t) {
    return any_of(a * (Interval(1.0) - t) + b * t, a + (b - a) * t);
}

Interval smoothstep(const Interval& edge0, const Interval& edge1, const Interval& x) {
    if (!(edge0.high() < edge1.low())) return Interval::anything();
    const Interval t = clamp((x - edge0) / (edge1 - edge0), Interval(0.0), Interval(1.0));
    return t * t * (Interval(3.0) - Interval(2.0) * t);
}

Interval ldexp(const Interval& x, int exponent) {
    if (x.bounds().empty()) return x;
    return enclose(monotonic(x.bounds(), [&](double v) { return std::ldexp(v, exponent); }));
}

Interval radians(const Interval& x) {
    return x * Interval(std::numbers::pi / 180.0);
}

Interval degrees(const Interval& x) {
    return x * Interval(180.0 / std::numbers::pi);
}

Interval quantize_to_half(const Interval& x) {
    const Bounds& b = x.bounds();
    if (b.empty()) return x;
    Bounds half{float16.round_down(b.low), float16.round_up(b.high), b.nan};
    const double normal = float16.smallest_normal();
    if (b.low > 0.0 && b.low < normal) half.low = 0.0;
    if (b.high < 0.0 && b.high > -normal) half.high = 0.0;
    return Interval::within(half);
}

Interval any_of(const Interval& a, const Interval& b) {
    const Bounds& x = a.bounds();
    const Bounds& y = b.bounds();
    const bool meet = x.empty() || y.empty() || (x.low <= y.high && y.low <= x.high);
    if (meet) return Interval::within(hull(x, y));
    return Paths::choose(2) == 0 ? a : b;
}

}  // namespace gloam::numeric
