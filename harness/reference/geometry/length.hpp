// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline double gloam_length(dvec3 v) {
    const double along = dot(v, gloam_safe_normalize(v, dvec3(0.0)));
    return along > 0.0 ? along : 0.0;
}

}  // namespace gloam::reference
