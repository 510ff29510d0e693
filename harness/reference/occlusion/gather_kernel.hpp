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
    const bool point = gloam_is_finite3(position) && !gloam_is_background(T(-position.z));
    const bool facing =
        gloam_is_finite3(normal) && max(max(abs(normal.x), abs(normal.y)), abs(normal.z)) >= float_min<T>();
    return point && facing && radius >= float_min<T>() && radius <= float_max<T>();
}

}  // namespace gloam::reference
