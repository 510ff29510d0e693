// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec4 gloam_bent_add(dvec4 bent, dvec3 direction, double visibility) {
    return is_finite(direction) ? bent + gloam_unit_interval(visibility) * dvec4(direction, 1.0) : bent;
}

inline dvec3 gloam_bent_normal(dvec4 bent, dvec3 normal) {
    return bent.w > 0.0 ? gloam_safe_normalize(bent, normal) : normal;
}

inline double gloam_bent_length(dvec4 bent) {
    const bool some = bent.w >= float_min && bent.w <= 0x1p126;
    return some ? min(gloam_length(bent) / bent.w, 1.0) : 1.0;
}

}  // namespace gloam::reference
