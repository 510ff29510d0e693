// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/projected_radius.hpp"

namespace gloam::reference {

inline double gloam_covering_radius_parallel(dvec3 position, double radius, double largest) {
    const double depth = -position.z;
    if (!is_finite(position) || gloam_is_background(depth) || !(radius > 0.0)) return 0.0;
    return min(radius / depth, gloam_positive_length(largest));
}

// R / (cos t (d - R sin t)), t the angle off the axis.
inline double gloam_covering_radius_perpendicular(dvec3 position, double radius, double largest) {
    const double depth = -position.z;
    if (!is_finite(position) || gloam_is_background(depth) || !(radius > 0.0)) return 0.0;
    const double t = atan(length(dvec2(position)) / depth);
    const double divisor = cos(t) * (depth - radius * sin(t));
    return divisor > 0.0 ? min(radius / divisor, gloam_positive_length(largest))
                         : gloam_positive_length(largest);
}

}  // namespace gloam::reference
