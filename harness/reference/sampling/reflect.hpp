// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline dvec3 gloam_reflect_sample(dvec3 s, dvec3 encoded) {
    const dvec3 zero(0.0);
    if (!(dot(s, s) <= 1e38)) return zero;
    const dvec3 n = gloam_safe_normalize(2.0 * encoded - 1.0, zero);
    const double squared = dot(n, n);
    if (!(squared > 0.5)) return s;
    return s - (2.0 * dot(s, n) / squared) * n;
}

}  // namespace gloam::reference
