// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_eye_march(vec3<T> position, vec3<T> direction, T radius, int index, int count, T jitter) {
    const int steps = std::clamp(count, 1, 16777216);
    const T along = (T(std::clamp(index, 0, steps - 1)) + gloam_unit_interval(jitter)) / T(steps);
    const bool marches = gloam_is_finite3(direction) && radius >= T(0) && gloam_is_finite(radius);
    return marches ? position + radius * along * direction : position;
}

}  // namespace gloam::reference
