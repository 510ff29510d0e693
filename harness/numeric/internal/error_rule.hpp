// SPDX-License-Identifier: MIT
#pragma once

#include "numeric/interval.hpp"

namespace gloam::numeric::internal {

// Exact bounds of a function computed in double are off by this part at most (the C library's are within an
// ULP of double; sums of a few of them within this).
inline constexpr double double_error = 0x1p-50;

// Bounds moved outwards by that part.
[[nodiscard]] Bounds inflated(const Bounds& computed);

// What the exact bounds came from: one argument whose result is known without error; one argument; or
// several, so that every result between the bounds has its own ULP.
enum class Arguments { exact, point, range };

// enclose(exact widened by `ulps` units in the last place).
[[nodiscard]] Interval within_ulps(const Bounds& exact, double ulps, Arguments arguments);

// Whether these arguments are one value each.
template <class... B>
[[nodiscard]] Arguments arguments_of(const B&... bounds) {
    return (bounds.is_point() && ...) ? Arguments::point : Arguments::range;
}

// enclose(exact widened by an absolute error).
[[nodiscard]] Interval within_absolute(const Bounds& exact, double error);

// The bounds of f over x where f is monotonic, rising or falling, NaN kept apart.
template <class F>
[[nodiscard]] Bounds monotonic(const Bounds& x, F&& f) {
    const double a = f(x.low);
    const double b = f(x.high);
    return {std::min(a, b), std::max(a, b), x.nan};
}

}  // namespace gloam::numeric::internal
