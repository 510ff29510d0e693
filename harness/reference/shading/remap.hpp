// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_remap(double ao, double a, double b, double c) {
    const double base = b * (ao + a);
    if (!(base > 0.0)) return base <= 0.0 && c > 0.0 ? 0.0 : 1.0;
    const bool open = c > 0.0 ? base >= 1.0 : (c < 0.0 ? base <= 1.0 : true);
    if (open) return 1.0;
    return c == 1.0 ? base : clamp(pow(base, c), 0.0, 1.0);
}

}  // namespace gloam::reference
