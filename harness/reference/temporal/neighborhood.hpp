// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

inline double gloam_neighborhood_change(dvec3 sample_position, dvec3 position, dvec3 previous_sample,
                                        dvec3 previous_position) {
    dvec3 a = sample_position - position;
    dvec3 b = previous_sample - previous_position;
    if (!(gloam_is_finite3(a) && gloam_is_finite3(b))) return float_max;
    const dvec3 bounds = max(abs(a), abs(b));
    const double largest = max(max(bounds.x, bounds.y), bounds.z);
    if (!(largest >= float_min)) return 0.0;
    const double scale = detail::squarable_scale(largest);
    a = a * scale;
    b = b * scale;
    const double sum = gloam_sqrt(dot(a, a)) + gloam_sqrt(dot(b, b));
    return min(abs(dot(a - b, a + b)) / sum / scale, float_max);
}

inline bool gloam_neighborhood_unchanged(double change, double epsilon) {
    return change < epsilon;
}

inline bool gloam_probe_useful(dvec3 offset, dvec3 normal) {
    return gloam_is_finite3(offset) && dot(offset, normal) > 0.0;
}

}  // namespace gloam::reference
