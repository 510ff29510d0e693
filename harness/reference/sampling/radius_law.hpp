// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_radius_linear(double zeta) {
    return gloam_unit_interval(zeta);
}

inline double gloam_radius_quadratic(double zeta) {
    return gloam_sqrt(gloam_unit_interval(zeta));
}

inline double gloam_radius_cubic(double zeta) {
    const double x = gloam_unit_interval(zeta);
    if (x < float_min) return 0.0;
    return cbrt(x);
}

}  // namespace gloam::reference
