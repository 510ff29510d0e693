// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

// Functions of GLSL that neither the standard library nor GLM has.
namespace gloam::reference {

// Half to even, whatever the rounding mode.
inline double round_even(double x) {
    const double down = std::floor(x);
    if (x - down != 0.5) return std::round(x);
    return std::fmod(down, 2.0) == 0.0 ? down : down + 1.0;
}

// The nearest float16, half to even.
inline double quantize_to_half(double x) {
    if (!(std::abs(x) < 65520.0)) return std::isnan(x) ? x : std::copysign(infinity, x);
    const int exponent = std::max(x == 0.0 ? -14 : std::ilogb(x), -14);
    const double unit = std::ldexp(1.0, exponent - 10);
    return round_even(x / unit) * unit;
}

}  // namespace gloam::reference
