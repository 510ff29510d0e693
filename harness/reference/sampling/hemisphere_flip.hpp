// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec3 gloam_hemisphere_flip(dvec3 s, dvec3 normal) {
    if (!(length(s) <= 1e19)) return dvec3(0.0);
    return dot(s, normal) > 0.0 ? s : -s;
}

}  // namespace gloam::reference
