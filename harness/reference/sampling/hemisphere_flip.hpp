// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec3 gloam_hemisphere_flip(dvec3 s, dvec3 normal) {
    if (!(dot(s, s) <= 1e38)) return dvec3(0.0);
    if (dot(s, normal) > 0.0) return s;
    return -s;
}

}  // namespace gloam::reference
