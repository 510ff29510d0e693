// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_remap(double ao, double a, double b, double c) {
    const double base = b * (ao + a);
    if (std::isnan(base) || std::isnan(c)) return 1.0;
    return base > 0.0 ? std::clamp(pow(base, c), 0.0, 1.0) : (c > 0.0 ? 0.0 : 1.0);
}

}  // namespace gloam::reference
