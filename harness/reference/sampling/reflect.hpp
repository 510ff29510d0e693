// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline dvec3 gloam_reflect_sample(dvec3 s, dvec3 encoded) {
    if (!(length(s) <= 1e19)) return dvec3(0.0);
    return glm::reflect(s, gloam_safe_normalize(2.0 * encoded - 1.0, dvec3(0.0)));
}

}  // namespace gloam::reference
