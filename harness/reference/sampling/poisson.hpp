// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

inline bool gloam_poisson_accepts(dvec2 candidate, dvec2 other, double min_distance) {
    const dvec2 offset = candidate - other;
    const double squared = dot(offset, offset);
    if (min_distance < 0.0) return squared >= 0.0;
    return squared > min_distance * min_distance;
}

inline dvec3 gloam_hemisphere_lift(dvec2 disc) {
    const dvec3 rim = gloam_safe_normalize(dvec3(disc.x, disc.y, 0.0), dvec3(0.0, 0.0, 1.0));
    if (!(dot(disc, disc) <= 1.5)) return rim;
    const dvec2 head = floor(disc * 4096.0) * 0.000244140625;
    const double height_squared = ((1.0 - head.x * head.x) - head.y * head.y) - dot(disc - head, disc + head);
    if (height_squared > 0.0) return dvec3(disc.x, disc.y, gloam_sqrt(height_squared));
    return dvec3(rim.x, rim.y, 0.0);
}

}  // namespace gloam::reference
