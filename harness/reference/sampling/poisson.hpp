// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
bool gloam_poisson_accepts(vec2<T> candidate, vec2<T> other, T min_distance) {
    const vec2<T> offset = candidate - other;
    const T squared = dot(offset, offset);
    if (min_distance < T(0)) return squared >= T(0);
    return squared > min_distance * min_distance;
}

template <class T>
vec3<T> gloam_hemisphere_lift(vec2<T> disc) {
    const vec3<T> rim = gloam_safe_normalize(vec3<T>(disc.x, disc.y, T(0)), vec3<T>(T(0), T(0), T(1)));
    if (!(dot(disc, disc) <= T(1.5))) return rim;
    const vec2<T> head = floor(disc * T(4096)) * T(0.000244140625);
    const T height_squared = ((T(1) - head.x * head.x) - head.y * head.y) - dot(disc - head, disc + head);
    if (height_squared > T(0)) return vec3<T>(disc.x, disc.y, gloam_sqrt(height_squared));
    return vec3<T>(rim.x, rim.y, T(0));
}

}  // namespace gloam::reference
