// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_radius_linear(double zeta) {
    return gloam_unit_interval(zeta);
}

inline double gloam_radius_quadratic(double zeta) {
    const double x = gloam_unit_interval(zeta);
    return x < float_min ? 0.0 : sqrt(x);
}

inline double gloam_radius_cubic(double zeta) {
    const double x = gloam_unit_interval(zeta);
    return x < float_min ? 0.0 : cbrt(x);
}

}  // namespace gloam::reference
