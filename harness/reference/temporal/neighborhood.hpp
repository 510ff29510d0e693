// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/length.hpp"

namespace gloam::reference {

// | |s - p| - |s' - p'| |.
inline double gloam_neighborhood_change(dvec3 sample_position, dvec3 position, dvec3 previous_sample,
                                        dvec3 previous_position) {
    const dvec3 now = sample_position - position;
    const dvec3 before = previous_sample - previous_position;
    if (!is_finite(now) || !is_finite(before)) return float_max;
    return min(abs(length(now) - length(before)), float_max);
}

inline bool gloam_neighborhood_unchanged(double change, double epsilon) {
    return change < epsilon;
}

inline bool gloam_probe_useful(dvec3 offset, dvec3 normal) {
    return is_finite(offset) && dot(offset, normal) > 0.0;
}

}  // namespace gloam::reference
