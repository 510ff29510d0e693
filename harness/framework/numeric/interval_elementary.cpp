// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "numeric/internal/error_rule.hpp"
#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

// Functions with an error rule of their own in Vulkan's table, and those that inherit from them.
namespace gloam::numeric {
namespace {

using internal::Arguments;
using internal::arguments_of;
using internal::Ends;
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

// Sines and arcs of smaller numbers are nearer to 0 than the number, by less than the error of double.
constexpr double near_zero = 0x1p-23;

double largest_magnitude(const Bounds& x) {
    return std::max(std::abs(x.low), std::abs(x.high));
}

// A finite argument has a finite result, even if double cannot represent it.
double finite_result(double argument, double result) {
    return std::isinf(result) && !std::isinf(argument) ? std::numeric_limits<double>::max() : result;
}

// A power of a small exponent is above or below 1, where the ULP changes, though double may not tell it.
double power_beside_one(double exponent, double power) {
    if (power != 1.0 || exponent == 0.0) return power;
    return std::nextafter(1.0, exponent > 0.0 ? 2.0 : 0.0);
}

template <class F>
Interval exponential(const Interval& x, bool exact, F&& f) {
    constexpr double small = 0x1p-30;  // the error of double then decides nothing
    const Bounds& b = x.bounds();
    if (b.nan) return Interval::anything();
    const Bounds power = monotonic(b, [&](double v) { return power_beside_one(v, finite_result(v, f(v))); });
    const double magnitude = largest_magnitude(b);
    const double slope = 2.0 * std::min(magnitude, Paths::format().largest());
    const bool known = exact || (b.is_point() && magnitude < small);
    const Interval result =
        within_ulps(power, rules().exp_ulps + slope, known ? Arguments::exact : arguments_of(b));
    // A power is not negative, so the error of a result that underflows extends to zero only.
    return Interval::within({std::max(result.low(), 0.0), result.high(), result.may_be_nan()});
}

template <class F>
Interval logarithm(const Interval& x, bool exact, F&& f) {
    const Bounds& b = x.bounds();
    if (b.nan || !(b.low > 0.0)) return Interval::anything();
    const auto part = [&](double low, double high) { return monotonic({low, high, false}, f); };
    const auto outside = [&](double low, double high) {
        return within_ulps(part(low, high), log_ulps, exact ? Arguments::exact : arguments_of(b)).bounds();
    };
    Bounds all{infinity, -infinity, false};
    if (b.low < 0.5) all = hull(all, outside(b.low, std::min(b.high, 0.5)));
    if (b.high > 2.0) all = hull(all, outside(std::max(b.low, 2.0), b.high));
    const Bounds inside{std::max(b.low, 0.5), std::min(b.high, 2.0), false};
    if (!inside.empty()) {
        const Bounds range = part(inside.low, inside.high);
        all = hull(
            all,
            within_absolute(exact ? range : inflated(range), rules().log_absolute, Ends::outside).bounds());
    }
    return Interval::within(all);
}

// Sine and cosine as cos(x - shift); the extrema are at shift + k pi.
Interval sinusoid(const Interval& x, double shift) {
    const Bounds& b = x.bounds();
    if (b.nan || b.empty()) return Interval::anything();
    if (b.low < -pi || b.high > pi) {
        if (!Paths::closes_gaps() || std::isinf(b.low) || std::isinf(b.high)) return Interval::anything();
        const bool huge = std::max(-b.low, b.high) > 0x1p50;  // extrema cannot be counted there
        if (huge || b.high - b.low >= pi) return Interval::within(-1.0, 1.0);
    }
    const auto f = [&](double v) { return shift == 0.0 ? std::cos(v) : std::sin(v); };
    const bool is_near_zero = shift != 0.0 && b.is_point() && std::abs(b.low) < near_zero;
    Bounds range = is_near_zero ? Bounds::point(std::nextafter(b.low, 0.0)) : inflated(monotonic(b, f));
    for (double k = std::ceil((b.low - shift) / pi); shift + k * pi <= b.high; ++k)
        range = hull(range, Bounds::point(std::fmod(k, 2.0) == 0.0 ? 1.0 : -1.0));
    const Interval result = within_absolute(range, rules().sine_absolute, Ends::inside);
    return Interval::within({std::max(result.low(), -1.0), std::min(result.high(), 1.0), false});
}

// The angles of a box on one side of the cut. On the cut itself the sign of a zero decides, and that sign may
// be lost.
Interval half_plane(const Bounds& y, const Bounds& x) {
    Bounds angle{infinity, -infinity, false};
    for (const double v : {y.low, y.high}) {
        for (const double u : {x.low, x.high}) angle = hull(angle, Bounds::point(std::atan2(v, u)));
    }
    return within_ulps(angle, rules().atan_ulps, arguments_of(y, x));
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
    return within_ulps(root, inversesqrt_ulps, arguments_of(b));
}

Interval sqrt(const Interval& x) {
    const Bounds& b = x.bounds();
    if (Paths::closes_gaps() && b.low == 0.0 && !b.nan) {
        if (b.high == 0.0) return Interval::within(0.0, 0.0);
        return Interval::within(0.0, sqrt(Interval::within(b.high, b.high)).high());
    }
    return Interval(1.0) / Formula::step([&] { return inversesqrt(x); });
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
    const Bounds& b = x.bounds();
    if (Paths::closes_gaps() && b.low == 0.0 && !b.nan && y.low() > 0.0 && !y.may_be_nan()) {
        if (b.high == 0.0) return Interval::within(0.0, 0.0);
        return Interval::within(0.0, pow(Interval::within(b.high, b.high), y).high());
    }
    return exp2(y * Formula::step([&] { return log2(x); }));
}

Interval sin(const Interval& x) {
    return sinusoid(x, pi / 2);
}

Interval cos(const Interval& x) {
    return sinusoid(x, 0.0);
}

Interval tan(const Interval& x) {
    const Interval sine = Formula::step([&] { return sin(x); });
    return sine / Formula::step([&] { return cos(x); });
}

Interval atan(const Interval& x) {
    if (x.may_be_nan() || x.bounds().empty()) return Interval::anything();
    const Bounds& b = x.bounds();
    if (b.is_point() && b.low != 0.0 && std::abs(b.low) < near_zero) {
        const Bounds angle = Bounds::point(std::nextafter(b.low, 0.0));
        return within_ulps(angle, rules().atan_ulps, Arguments::exact);
    }
    const Bounds angle = monotonic(b, [](double v) { return std::atan(v); });
    return within_ulps(angle, rules().atan_ulps, arguments_of(b));
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
    return atan(x, Formula::step([&] { return sqrt(Interval(1.0) - x * x); }));
}

Interval acos(const Interval& x) {
    return atan(Formula::step([&] { return sqrt(Interval(1.0) - x * x); }), x);
}

Interval sinh(const Interval& x) {
    return Formula::step([&] { return exp(x) - exp(-x); }) * Interval(0.5);
}

Interval cosh(const Interval& x) {
    return Formula::step([&] { return exp(x) + exp(-x); }) * Interval(0.5);
}

Interval tanh(const Interval& x) {
    const Interval sine = Formula::step([&] { return sinh(x); });
    return sine / Formula::step([&] { return cosh(x); });
}

Interval asinh(const Interval& x) {
    return log(x + Formula::step([&] { return sqrt(x * x + Interval(1.0)); }));
}

Interval acosh(const Interval& x) {
    return log(x + Formula::step([&] { return sqrt(x * x - Interval(1.0)); }));
}

Interval atanh(const Interval& x) {
    const auto half_of = [&] { return log((Interval(1.0) + x) / (Interval(1.0) - x)); };
    return Formula::step(half_of) * Interval(0.5);
}

}  // namespace gloam::numeric
