// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_reflect_sample(vec3<T> s, vec3<T> encoded) {
    const vec3<T> zero(T(0), T(0), T(0));
    if (!(dot(s, s) <= T(1e38))) return zero;
    const vec3<T> n = gloam_safe_normalize(T(2) * encoded - T(1), zero);
    const T squared = dot(n, n);
    if (!(squared > T(0.5))) return s;
    return s - (T(2) * dot(s, n) / squared) * n;
}

}  // namespace gloam::reference
