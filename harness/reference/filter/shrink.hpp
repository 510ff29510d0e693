// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_shrink(double convergence, double c_adaptive) {
    if (!(c_adaptive >= 1e-30) || convergence >= c_adaptive) return 0.0;
    if (!(convergence > 0.0) || c_adaptive > float_max) return 1.0;
    return min((c_adaptive - convergence) / c_adaptive, 1.0);
}

inline double gloam_window_coverage(int offset, double reach) {
    return gloam_unit_interval(reach - double(offset - 1));
}

}  // namespace gloam::reference
