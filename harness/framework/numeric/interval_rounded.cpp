// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "numeric/internal/error_rule.hpp"
#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

// Functions whose results Vulkan requires to be correct or correctly rounded, and functions composed of
// these.
namespace gloam::numeric {
namespace {

using internal::monotonic;

// One of the whole numbers in the bounds, each a way of its own; all of them where these are too many.
Bounds one_whole(const Bounds& all) {
    const double count = all.high - all.low + 1.0;
    const auto chosen = count > 1.0 ? Paths::choose_whole(count) : std::nullopt;
    if (!chosen) return all;
    const double one = all.low + static_cast<double>(*chosen);
    return {one, one, all.nan};
}

// Of an f whose results are whole numbers.
template <class F>
Interval exactly(const Interval& x, F&& f) {
    if (x.bounds().empty()) return x;
    return Interval::within(one_whole(monotonic(x.bounds(), f)));
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

// What a formula permits is permitted to an operation that inherits from it; with NaN, anything.
Interval inherited(const Interval& formula) {
    return formula.may_be_nan() ? Interval::anything() : formula;
}

bool is_point(const Interval& x) {
    return x.bounds().is_point();
}

bool is_bounded(const Interval& x) {
    return !x.may_be_nan() && std::isfinite(x.low()) && std::isfinite(x.high());
}

// A formula that names an argument twice has wider intervals than results. This is the part of `all` within
// the exact range, which is widened by the rounding errors of a few operations on numbers of this magnitude.
Interval narrowed(const Interval& all, const Bounds& range, double magnitude) {
    constexpr double operations = 6.0;
    const FloatFormat& format = Paths::format();
    const double slack =
        operations * (std::ldexp(magnitude, 1 - format.precision) + format.smallest_normal());
    const Bounds wide = enclose({range.low - slack, range.high + slack, false}).bounds();
    return Interval::within(
        {std::max(all.low(), wide.low), std::min(all.high(), wide.high), all.may_be_nan()});
}

// x (1 - t) + y t and x + (y - x) t, as intervals.
Interval mix_in_order(const Interval& x, const Interval& y, const Interval& t) {
    return inherited(any_of(x * (Interval(1.0) - t) + y * t, x + (y - x) * t));
}

// A product with a constant that is rounded correctly: to either neighbour, unless it is known what runs.
Interval times_constant(const Interval& x, double constant) {
    const Interval rounded = enclose(Bounds::point(constant));
    const Paths::EitherWay either;
    return x * rounded;
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
    const auto is_whole = [](double v) {
        return std::trunc(v) == v;
    };  // of large doubles, v + 0.5 is rounded
    return Interval::within(
        one_whole({is_whole(x.low()) ? x.low() : std::ceil(x.low() - 0.5),
                   is_whole(x.high()) ? x.high() : std::floor(x.high() + 0.5), x.may_be_nan()}));
}

Interval fract(const Interval& x) {
    const Bounds& b = x.bounds();
    if (b.empty() || std::isinf(b.low) || std::isinf(b.high)) return Interval::within({0.0, 1.0, true});
    const Bounds whole = one_whole({std::floor(b.low), std::floor(b.high), false});
    if (!whole.is_point()) return Interval::within({0.0, 1.0, b.nan});
    return Interval::within({std::max(b.low, whole.low), std::min(b.high, whole.low + 1.0), b.nan}) -
           Interval::within(whole);
}

Interval mod(const Interval& x, const Interval& y) {
    return inherited(x - y * floor(Formula::step([&] { return x / y; })));
}

Interval remainder(const Interval& x, const Interval& y) {
    return inherited(x - y * trunc(Formula::step([&] { return x / y; })));
}

// Linear in each operand: its extrema are at the corners.
Interval mix(const Interval& x, const Interval& y, const Interval& t) {
    const Interval all = mix_in_order(x, y, t);
    if ((is_point(x) && is_point(y) && is_point(t)) || !is_bounded(x) || !is_bounded(y) || !is_bounded(t))
        return all;
    Bounds range{infinity, -infinity, false};
    double magnitude = 0.0;
    for (const double a : {x.low(), x.high()}) {
        for (const double b : {y.low(), y.high()}) {
            for (const double at : {t.low(), t.high()}) {
                range = hull(range, Bounds::point(a * (1.0 - at) + b * at));
                magnitude = std::max(magnitude, (std::abs(a) + std::abs(b)) * (1.0 + std::abs(at)));
            }
        }
    }
    return narrowed(all, range, magnitude);
}

// Rises with t from 0 to 1.
Interval smoothstep(const Interval& edge0, const Interval& edge1, const Interval& x) {
    if (!(edge0.high() < edge1.low())) return Interval::anything();
    const Interval t =
        clamp(Formula::step([&] { return (x - edge0) / (edge1 - edge0); }), Interval(0.0), Interval(1.0));
    const Interval all = t * t * (Interval(3.0) - Interval(2.0) * t);
    if (is_point(t) || !is_bounded(t)) return all;
    const auto curve = [](double v) { return v * v * (3.0 - 2.0 * v); };
    return narrowed(all, monotonic(t.bounds(), curve), 3.0);
}

Interval times_power_of_two(const Interval& x, int exponent) {
    if (x.bounds().empty()) return x;
    return enclose(monotonic(x.bounds(), [&](double v) { return std::ldexp(v, exponent); }));
}

Interval ldexp(const Interval& x, int exponent) {
    const FloatFormat& format = float32;  // the type's limits, also where half precision is permitted
    const Bounds& b = x.bounds();
    const bool may_be_finite = !b.empty() && !(std::isinf(b.low) && b.low == b.high);
    const double largest = std::min(std::max(std::abs(b.low), std::abs(b.high)), format.largest());
    const bool too_large = may_be_finite && std::ldexp(largest, exponent) > format.largest();
    if (exponent > format.max_exponent + 1 || too_large) return Interval::anything();
    const Interval all = times_power_of_two(x, exponent);
    if (exponent >= format.min_exponent || b.empty()) return all;
    return Interval::within(hull(all.bounds(), Bounds::point(0.0)));
}

Interval radians(const Interval& x) {
    return times_constant(x, std::numbers::pi / 180.0);
}

Interval degrees(const Interval& x) {
    return times_constant(x, 180.0 / std::numbers::pi);
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

Interval sum_in_any_order(std::span<const Interval> p) {
    const auto three = [&p](std::size_t a, std::size_t b, std::size_t c) {
        return any_of((p[a] + p[b]) + p[c], any_of((p[a] + p[c]) + p[b], (p[b] + p[c]) + p[a]));
    };
    if (p.size() == 1) return p[0];
    if (p.size() == 2) return p[0] + p[1];
    if (p.size() == 3) return three(0, 1, 2);
    const auto pairs = [&p](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
        return (p[a] + p[b]) + (p[c] + p[d]);
    };
    const Interval chains = any_of(any_of(three(0, 1, 2) + p[3], three(0, 1, 3) + p[2]),
                                   any_of(three(0, 2, 3) + p[1], three(1, 2, 3) + p[0]));
    return any_of(chains, any_of(pairs(0, 1, 2, 3), any_of(pairs(0, 2, 1, 3), pairs(0, 3, 1, 2))));
}

}  // namespace gloam::numeric
