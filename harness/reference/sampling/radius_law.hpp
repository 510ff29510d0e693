// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_radius_linear(T zeta) {
    return gloam_unit_interval(zeta);
}

template <class T>
T gloam_radius_quadratic(T zeta) {
    return sqrt(gloam_unit_interval(zeta));
}

template <class T>
T gloam_radius_cubic(T zeta) {
    if (zeta < float_min<T>()) return T(0);
    return cbrt(gloam_unit_interval(zeta));
}

}  // namespace gloam::reference
