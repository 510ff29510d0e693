// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/sampling/circle.hpp"

namespace gloam::reference {

inline dvec3 gloam_hemisphere_cosine(dvec3 zeta) {
    const double radius = gloam_unit_interval(zeta.y);
    const double cosine_squared = gloam_unit_interval(zeta.z);
    const dvec2 side = gloam_sqrt(1.0 - cosine_squared) * gloam_circle_point(zeta.x);
    return radius * dvec3(side.x, side.y, gloam_sqrt(cosine_squared));
}

inline dvec3 gloam_hemisphere_uniform(dvec3 zeta) {
    const double radius = gloam_unit_interval(zeta.y);
    const double cosine = gloam_unit_interval(zeta.z);
    const dvec2 side = gloam_sqrt((1.0 - cosine) * (1.0 + cosine)) * gloam_circle_point(zeta.x);
    return radius * dvec3(side.x, side.y, cosine);
}

}  // namespace gloam::reference
