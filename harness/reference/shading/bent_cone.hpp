// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_cone_angle_linear(double agreement) {
    return (1.0 - max(0.0, 2.0 * gloam_unit_interval(agreement) - 1.0)) * pi / 2.0;
}

// (1 + cos a) / 2 = L.
inline double gloam_cone_angle(double agreement) {
    return acos(max(0.0, 2.0 * gloam_unit_interval(agreement) - 1.0));
}

inline double gloam_cone_angle_uniform(double visibility) {
    return acos(1.0 - gloam_unit_interval(visibility));
}

inline double gloam_cone_angle_cosine(double visibility) {
    return asin(sqrt(gloam_unit_interval(visibility)));
}

}  // namespace gloam::reference
