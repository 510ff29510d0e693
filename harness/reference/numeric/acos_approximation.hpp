// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_clamp_cosine(double x) {
    return std::isnan(x) ? 0.0 : std::clamp(x, -1.0, 1.0);
}

inline double gloam_acos_linear(double x) {
    return pi / 2.0 * (1.0 - gloam_clamp_cosine(x));
}

inline double gloam_acos_quadratic(double x) {
    return pi / 2.0 - std::copysign(pi / 2.0 * pow(gloam_clamp_cosine(x), 2), x);
}

// In degrees: 90 - 50 c - 40 c^3.
inline double gloam_acos_cubic(double x) {
    const double c = gloam_clamp_cosine(x);
    return pi / 180.0 * (90.0 - 50.0 * c - 40.0 * pow(c, 3));
}

}  // namespace gloam::reference
