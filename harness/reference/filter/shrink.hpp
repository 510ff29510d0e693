// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_shrink(T convergence, T c_adaptive) {
    if (!(c_adaptive >= T(1e-30)) || convergence >= c_adaptive) return T(0);
    if (!(convergence > T(0)) || c_adaptive > float_max<T>()) return T(1);
    return min((c_adaptive - convergence) / c_adaptive, T(1));
}

template <class T>
T gloam_window_coverage(int offset, T reach) {
    return gloam_unit_interval(reach - T(offset - 1));
}

}  // namespace gloam::reference
