// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec4<T> gloam_bent_add(vec4<T> bent, vec3<T> direction, T visibility) {
    if (!gloam_is_finite3(direction)) return bent;
    return bent + gloam_unit_interval(visibility) * vec4<T>(direction.x, direction.y, direction.z, T(1));
}

template <class T>
vec3<T> gloam_bent_normal(vec4<T> bent, vec3<T> normal) {
    return bent.w > T(0) ? gloam_safe_normalize(vec3<T>(bent.x, bent.y, bent.z), normal) : normal;
}

template <class T>
T gloam_bent_length(vec4<T> bent) {
    const bool some = bent.w >= float_min<T>() && bent.w <= T(0x1p126);
    const T agreement = some ? gloam_length(vec3<T>(bent.x, bent.y, bent.z)) / bent.w : T(1);
    return agreement < T(1) ? agreement : T(1);
}

}  // namespace gloam::reference
