// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_sample_cosine(dvec3 offset, dvec3 normal) {
    return gloam_unit_interval(dot(gloam_safe_normalize(offset, dvec3(0.0)), normal));
}

}  // namespace gloam::reference
