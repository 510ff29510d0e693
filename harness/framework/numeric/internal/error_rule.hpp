// SPDX-License-Identifier: MIT
#pragma once

#include "numeric/interval.hpp"

namespace gloam::numeric::internal {

// Relative error of exact bounds that are computed in double, at most. (The C library's functions are within
// an ULP of double; sums of a few of them are within this error.)
inline constexpr double double_error = 0x1p-50;

// a + b rounded towards -infinity in double.
[[nodiscard]] double sum_down(double a, double b);

// Bounds widened by that error.
[[nodiscard]] Bounds inflated(const Bounds& computed);

// The arguments of computed bounds: one argument whose result is known without error; one argument; or
// several, so that every result between the bounds has its own ULP.
enum class Arguments { exact, point, range };

// All floats in `computed` widened by `ulps` units in the last place, and by the error of double.
[[nodiscard]] Interval within_ulps(const Bounds& computed, double ulps, Arguments arguments);

// Whether each of these arguments is a single value.
template <class... B>
[[nodiscard]] Arguments arguments_of(const B&... bounds) {
    return (bounds.is_point() && ...) ? Arguments::point : Arguments::range;
}

// All floats in `exact` widened by an absolute error, with the ends (at most) or without them (below).
enum class Ends { inside, outside };
[[nodiscard]] Interval within_absolute(const Bounds& exact, double error, Ends ends);

// The bounds of a monotonic f over x, rising or falling; NaN is handled separately.
template <class F>
[[nodiscard]] Bounds monotonic(const Bounds& x, F&& f) {
    const double a = f(x.low);
    const double b = f(x.high);
    return {std::min(a, b), std::max(a, b), x.nan};
}

}  // namespace gloam::numeric::internal
