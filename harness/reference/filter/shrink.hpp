// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_shrink(double convergence, double c_adaptive) {
    if (!(c_adaptive >= 1e-30)) return 0.0;
    if (std::isnan(convergence)) return 1.0;
    if (std::isinf(c_adaptive)) return std::isinf(convergence) && convergence > 0.0 ? 0.0 : 1.0;
    return max(c_adaptive - max(convergence, 0.0), 0.0) / c_adaptive;
}

inline double gloam_window_coverage(int offset, double reach) {
    return gloam_unit_interval(reach - (offset - 1.0));
}

}  // namespace gloam::reference
