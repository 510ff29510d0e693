// SPDX-License-Identifier: MIT
#include "numeric/internal/error_rule.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

Bounds inflated(const Bounds& computed) {
    return {moved_out(computed.low, -std::abs(computed.low) * double_error),
            moved_out(computed.high, std::abs(computed.high) * double_error), computed.nan};
}

Interval within_ulps(const Bounds& exact, double ulps, Arguments arguments) {
    if (exact.empty()) return Interval::within(exact);
    const FloatFormat& format = Paths::format();
    // `inner`: the numbers next to this end lie further from zero than the end itself.
    const auto unit = [&](double x, bool inner) {
        if (std::isinf(x)) return 0.0;
        if (arguments == Arguments::exact) return format.ulp(x);
        return arguments == Arguments::range && inner ? reaching_ulp(format, x, ulps) : own_ulp(format, x);
    };
    return enclose({moved_out(exact.low, -ulps * unit(exact.low, exact.low > 0.0)),
                    moved_out(exact.high, ulps * unit(exact.high, exact.high < 0.0)), exact.nan});
}

Interval within_absolute(const Bounds& exact, double error) {
    if (exact.empty()) return Interval::within(exact);
    return enclose({exact.low - error, exact.high + error, exact.nan});
}

}  // namespace gloam::numeric::internal
