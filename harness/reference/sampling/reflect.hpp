// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_reflect_sample(vec3<T> s, vec3<T> encoded) {
    const vec3<T> zero(T(0), T(0), T(0));
    if (!(dot(s, s) <= T(1e38))) return zero;
    const vec3<T> direction = T(2) * encoded - vec3<T>(T(1), T(1), T(1));
    const vec3<T> n = gloam_safe_normalize(direction, zero);
    return s - T(2) * dot(s, n) * n;
}

}  // namespace gloam::reference
