// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec3 gloam_eye_march(dvec3 position, dvec3 direction, double radius, int index, int count,
                             double jitter) {
    if (!is_finite(direction) || !(radius >= 0.0) || std::isinf(radius)) return position;
    const int steps = std::clamp(count, 1, 16777216);
    const double travelled = std::clamp(index, 0, steps - 1) + gloam_unit_interval(jitter);
    return position + direction * (radius * travelled / steps);
}

}  // namespace gloam::reference
