// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec3 gloam_eye_march(dvec3 position, dvec3 direction, double radius, int index, int count,
                             double jitter) {
    const int steps = std::clamp(count, 1, 16777216);
    const double along =
        (double(std::clamp(index, 0, steps - 1)) + gloam_unit_interval(jitter)) / double(steps);
    const bool marches = gloam_is_finite3(direction) && radius >= 0.0 && gloam_is_finite(radius);
    return marches ? position + radius * along * direction : position;
}

}  // namespace gloam::reference
