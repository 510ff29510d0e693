// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// Step, linear, quadratic, cubic; any other number is linear.
inline double gloam_falloff_at(unsigned falloff, double x) {
    if (falloff == 0U) return x <= 1.0 ? 1.0 : 0.0;
    return 1.0 - pow(x, falloff <= 3U ? falloff : 1U);
}

}  // namespace gloam::reference
