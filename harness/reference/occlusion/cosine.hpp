// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline double gloam_sample_cosine(dvec3 offset, dvec3 normal) {
    const double cosine = dot(gloam_safe_normalize(offset, dvec3(0.0)), normal);
    return cosine > 0.0 ? (cosine < 1.0 ? cosine : 1.0) : 0.0;
}

}  // namespace gloam::reference
