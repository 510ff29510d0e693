// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_hemisphere_flip(vec3<T> s, vec3<T> normal) {
    if (!(dot(s, s) <= T(1e38))) return vec3<T>(T(0), T(0), T(0));
    if (dot(s, normal) > T(0)) return s;
    return -s;
}

}  // namespace gloam::reference
