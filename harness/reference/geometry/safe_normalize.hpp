// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_safe_normalize(vec3<T> v, vec3<T> fallback) {
    if (!gloam_is_finite3(v)) return fallback;
    const bool zero = abs(v.x) < float_min<T>() && abs(v.y) < float_min<T>() && abs(v.z) < float_min<T>();
    if (zero) return fallback;
    return normalize(v);
}

}  // namespace gloam::reference
