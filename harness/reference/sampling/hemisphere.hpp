// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/circle.hpp"

namespace gloam::reference {

inline dvec3 gloam_hemisphere_cosine(dvec3 zeta) {
    const double squared = gloam_unit_interval(zeta.z);
    const double across = sqrt(1.0 - squared);
    return gloam_unit_interval(zeta.y) * dvec3(across * gloam_circle_point(zeta.x), sqrt(squared));
}

// By the angle off the normal, whose cosine is uniform.
inline dvec3 gloam_hemisphere_uniform(dvec3 zeta) {
    const double angle = acos(gloam_unit_interval(zeta.z));
    return gloam_unit_interval(zeta.y) * dvec3(sin(angle) * gloam_circle_point(zeta.x), cos(angle));
}

}  // namespace gloam::reference
