// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_poisson_accepts(dvec2 candidate, dvec2 other, double min_distance) {
    return distance(candidate, other) > min_distance;
}

inline dvec3 gloam_hemisphere_lift(dvec2 disc) {
    if (!is_finite(disc)) return {0.0, 0.0, 1.0};
    const double r = length(disc);
    return r < 1.0 ? dvec3(disc, sqrt(1.0 - r * r)) : dvec3(disc / r, 0.0);
}

}  // namespace gloam::reference
