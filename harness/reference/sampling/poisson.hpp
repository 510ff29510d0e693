// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
bool gloam_poisson_accepts(vec2<T> candidate, vec2<T> other, T min_distance) {
    return distance(candidate, other) > min_distance;
}

template <class T>
vec3<T> gloam_hemisphere_lift(vec2<T> disc) {
    if (!is_finite(disc)) return vec3<T>(T(0), T(0), T(1));
    const T squared = dot(disc, disc);
    if (squared < T(1)) return vec3<T>(disc.x, disc.y, sqrt(T(1) - squared));
    const vec2<T> rim = normalize(disc);
    return vec3<T>(rim.x, rim.y, T(0));
}

}  // namespace gloam::reference
