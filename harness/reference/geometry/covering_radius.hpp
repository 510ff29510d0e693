// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"
#include "reference/geometry/projected_radius.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

inline double gloam_covering_radius_parallel(dvec3 position, double radius, double largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > 0.0 && largest > 0.0))
        return 0.0;
    const double depth = clamp(-position.z, float_min, 0x1p126);
    const double r = radius / depth;
    return min(r, gloam_positive_length(largest));
}

inline double gloam_covering_radius_perpendicular(dvec3 position, double radius, double largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > 0.0 && largest > 0.0))
        return 0.0;
    const double depth = -position.z;
    const double across = gloam_sqrt(dot(dvec2(position.x, position.y), dvec2(position.x, position.y)));
    const double along = gloam_sqrt(dot(position, position));
    const double denominator = (depth / along) * (depth - radius * (across / along));
    if (!(denominator >= float_min)) return gloam_positive_length(largest);
    const double r = radius / min(denominator, 0x1p126);
    return min(r, gloam_positive_length(largest));
}

}  // namespace gloam::reference
