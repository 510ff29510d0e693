// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
struct GloamKernel {
    T radius;
    T bias;
    T angle;
    unsigned first;
    unsigned count;
};

template <class T>
bool gloam_can_gather(vec3<T> position, vec3<T> normal, T radius) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z)) return false;
    if (!gloam_is_finite3(normal)) return false;
    const T least = float_min<T>();
    const bool no_normal = abs(normal.x) < least && abs(normal.y) < least && abs(normal.z) < least;
    return !no_normal && radius >= least && radius <= float_max<T>();
}

}  // namespace gloam::reference
