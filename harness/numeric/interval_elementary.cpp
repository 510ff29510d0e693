// SPDX-License-Identifier: MIT
// Functions with an error rule of their own in Vulkan's table, and those that inherit from them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/constants.hpp"
#include "numeric/internal/error_rule.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

using internal::Arguments;
using internal::arguments_of;
using internal::inflated;
using internal::monotonic;
using internal::within_absolute;
using internal::within_ulps;

constexpr double pi = std::numbers::pi;

// The numbers of Vulkan's table for one format.
struct Rules {
    double exp_ulps;       // plus 2 |x|
    double log_absolute;   // inside [0.5, 2]
    double sine_absolute;  // inside [-pi, pi]
    double atan_ulps;
};

Rules rules() {
    if (Paths::format() == float16) return {1.0, 0x1p-7, 0x1p-7, 5.0};
    return {3.0, 0x1p-21, 0x1p-11, 4096.0};
}

constexpr double inversesqrt_ulps = 2.0;
constexpr double log_ulps = 3.0;

double largest_magnitude(const Bounds& x) {
    return std::max(std::abs(x.low), std::abs(x.high));
}

// A finite argument has a finite result, even if double cannot represent it.
double finite_result(double argument, double result) {
    return std::isinf(result) && !std::isinf(argument) ? std::numeric_limits<double>::max() : result;
}

template <class F>
Interval exponential(const Interval& x, bool exact, F&& f) {
    const Bounds& b = x.bounds();
    if (b.nan) return Interval::anything();
    const Bounds power = monotonic(b, [&](double v) { return finite_result(v, f(v)); });
    const double magnitude = largest_magnitude(b);
    const double slope = 2.0 * std::min(magnitude, Paths::format().largest());
    const Interval result = within_ulps(exact ? power : inflated(power), rules().exp_ulps + slope,
                                        exact ? Arguments::exact : arguments_of(b));
    // A power is not negative, so the error of a result that underflows extends to zero only.
    return Interval::within({std::max(result.low(), 0.0), result.high(), result.may_be_nan()});
}

template <class F>
Interval logarithm(const Interval& x, bool exact, F&& f) {
    const Bounds& b = x.bounds();
    if (b.nan || !(b.low > 0.0)) return Interval::anything();
    const auto part = [&](double low, double high) {
        const Bounds range = monotonic({low, high, false}, f);
        return exact ? range : inflated(range);
    };
    const auto outside = [&](double low, double high) {
        return within_ulps(part(low, high), log_ulps, exact ? Arguments::exact : arguments_of(b)).bounds();
    };
    Bounds all{infinity, -infinity, false};
    if (b.low < 0.5) all = hull(all, outside(b.low, std::min(b.high, 0.5)));
    if (b.high > 2.0) all = hull(all, outside(std::max(b.low, 2.0), b.high));
    const Bounds inside{std::max(b.low, 0.5), std::min(b.high, 2.0), false};
    if (!inside.empty()) {
        all = hull(all, within_absolute(part(inside.low, inside.high), rules().log_absolute).bounds());
    }
    return Interval::within(all);
}

// Sine and cosine as cos(x - shift); the extrema are at shift + k pi.
Interval sinusoid(const Interval& x, double shift) {
    const Bounds& b = x.bounds();
    if (b.nan || b.empty() || b.low < -pi || b.high > pi) return Interval::anything();
    const auto f = [&](double v) { return shift == 0.0 ? std::cos(v) : std::sin(v); };
    Bounds range = inflated(monotonic(b, f));
    for (int k = -2; k <= 2; ++k) {
        const double turn = shift + k * pi;
        if (b.low <= turn && turn <= b.high) range = hull(range, Bounds::point(k % 2 == 0 ? 1.0 : -1.0));
    }
    const Interval result = within_absolute(range, rules().sine_absolute);
    return Interval::within({std::max(result.low(), -1.0), std::min(result.high(), 1.0), false});
}

// The angles of a box on one side of the cut. On the cut itself the sign of a zero decides, and that sign may
// be lost.
Interval half_plane(const Bounds& y, const Bounds& x) {
    Bounds angle{infinity, -infinity, false};
    for (const double v : {y.low, y.high}) {
        for (const double u : {x.low, x.high}) angle = hull(angle, Bounds::point(std::atan2(v, u)));
    }
    return within_ulps(inflated(angle), rules().atan_ulps, arguments_of(y, x));
}

}  // namespace

Interval inversesqrt(const Interval& x) {
    const Bounds& b = x.bounds();
    if (b.nan || !(b.low > 0.0)) return Interval::anything();
    const Bounds root = monotonic(b, [](double v) { return 1.0 / std::sqrt(v); });
    int exponent = 0;
    const bool exact =
        b.is_point() && std::frexp(root.low, &exponent) == 0.5 && root.low * root.low * b.low == 1.0;
    if (exact) return within_ulps(root, inversesqrt_ulps, Arguments::exact);
    return within_ulps(inflated(root), inversesqrt_ulps, arguments_of(b));
}

Interval sqrt(const Interval& x) {
    return Interval(1.0) / inversesqrt(x);
}

Interval exp(const Interval& x) {
    const bool exact = x.bounds() == Bounds::point(0.0);
    return exponential(x, exact, [](double v) { return std::exp(v); });
}

Interval exp2(const Interval& x) {
    const bool exact = x.bounds().is_point() && std::trunc(x.low()) == x.low();
    return exponential(x, exact, [](double v) { return std::exp2(v); });
}

Interval log(const Interval& x) {
    return logarithm(x, false, [](double v) { return std::log(v); });
}

Interval log2(const Interval& x) {
    int exponent = 0;
    const bool power_of_two = x.bounds().is_point() && std::frexp(x.low(), &exponent) == 0.5;
    return logarithm(x, power_of_two, [](double v) { return std::log2(v); });
}

Interval pow(const Interval& x, const Interval& y) {
    return exp2(y * log2(x));
}

Interval sin(const Interval& x) {
    return sinusoid(x, pi / 2);
}

Interval cos(const Interval& x) {
    return sinusoid(x, 0.0);
}

Interval tan(const Interval& x) {
    return sin(x) / cos(x);
}

Interval atan(const Interval& x) {
    if (x.may_be_nan() || x.bounds().empty()) return Interval::anything();
    const Bounds angle = monotonic(x.bounds(), [](double v) { return std::atan(v); });
    return within_ulps(inflated(angle), rules().atan_ulps, arguments_of(x.bounds()));
}

// The angle is monotonic along each edge of a box that does not touch the cut (y = 0, x <= 0), so its extrema
// are at corners.
Interval atan(const Interval& y, const Interval& x) {
    const Bounds& v = y.bounds();
    const Bounds& u = x.bounds();
    if (v.nan || u.nan || v.empty() || u.empty()) return Interval::anything();
    if (v.contains(0.0) && u.contains(0.0)) return Interval::anything();
    if (v.contains(0.0) && u.high < 0.0) {
        const Bounds above{0.0, v.high > 0.0 ? v.high : 0.0, false};
        const Bounds below{v.low < 0.0 ? v.low : -0.0, -0.0, false};
        return any_of(half_plane(above, u), half_plane(below, u));
    }
    return half_plane(v, u);
}

Interval asin(const Interval& x) {
    return atan(x, sqrt(Interval(1.0) - x * x));
}

Interval acos(const Interval& x) {
    return atan(sqrt(Interval(1.0) - x * x), x);
}

Interval sinh(const Interval& x) {
    return (exp(x) - exp(-x)) * Interval(0.5);
}

Interval cosh(const Interval& x) {
    return (exp(x) + exp(-x)) * Interval(0.5);
}

Interval tanh(const Interval& x) {
    return sinh(x) / cosh(x);
}

Interval asinh(const Interval& x) {
    return log(x + sqrt(x * x + Interval(1.0)));
}

Interval acosh(const Interval& x) {
    return log(x + sqrt(x * x - Interval(1.0)));
}

Interval atanh(const Interval& x) {
    return log((Interval(1.0) + x) / (Interval(1.0) - x)) * Interval(0.5);
}

}  // namespace gloam::numeric
