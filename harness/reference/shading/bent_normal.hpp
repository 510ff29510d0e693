// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec4 gloam_bent_add(dvec4 bent, dvec3 direction, double visibility) {
    if (!gloam_is_finite3(direction)) return bent;
    return bent + gloam_unit_interval(visibility) * dvec4(direction.x, direction.y, direction.z, 1.0);
}

inline dvec3 gloam_bent_normal(dvec4 bent, dvec3 normal) {
    return bent.w > 0.0 ? gloam_safe_normalize(dvec3(bent.x, bent.y, bent.z), normal) : normal;
}

inline double gloam_bent_length(dvec4 bent) {
    const bool some = bent.w >= float_min && bent.w <= 0x1p126;
    const double agreement = some ? gloam_length(dvec3(bent.x, bent.y, bent.z)) / bent.w : 1.0;
    return agreement < 1.0 ? agreement : 1.0;
}

}  // namespace gloam::reference
