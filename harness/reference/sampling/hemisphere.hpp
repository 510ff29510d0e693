// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/sampling/circle.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_hemisphere_cosine(vec3<T> zeta) {
    const T radius = gloam_unit_interval(zeta.y);
    const T cosine_squared = gloam_unit_interval(zeta.z);
    const vec2<T> side = gloam_sqrt(T(1) - cosine_squared) * gloam_circle_point(zeta.x);
    return radius * vec3<T>(side.x, side.y, gloam_sqrt(cosine_squared));
}

template <class T>
vec3<T> gloam_hemisphere_uniform(vec3<T> zeta) {
    const T radius = gloam_unit_interval(zeta.y);
    const T cosine = gloam_unit_interval(zeta.z);
    const vec2<T> side = gloam_sqrt((T(1) - cosine) * (T(1) + cosine)) * gloam_circle_point(zeta.x);
    return radius * vec3<T>(side.x, side.y, cosine);
}

}  // namespace gloam::reference
