// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_geometry_weight(vec3<T> normal, vec3<T> other, T depth_difference, T normal_power, T position_power) {
    const T facing = T(0.5) * dot(normal, other) + T(0.5);
    const T apart = T(1) + abs(depth_difference);
    if (!(facing > T(0) && apart <= float_max<T>() && normal_power > T(0) && position_power >= T(0)))
        return T(0);
    const T by_normal = facing < T(1) ? normal_power * log2(facing) : T(0);
    const T by_depth = apart > T(1) ? position_power * log2(apart) : T(0);
    const T x = by_normal - by_depth;
    const T weight = min(exp2(x), T(1));
    return x >= T(-99.5) ? weight : T(0);
}

}  // namespace gloam::reference
