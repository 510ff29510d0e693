// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// Finite as a float: a number that only a wider type can hold counts as infinite.
template <class T>
bool gloam_is_finite(T x) {
    return abs(x) <= float_max<T>();
}

template <class T>
bool gloam_is_finite2(vec2<T> v) {
    return gloam_is_finite(v.x) && gloam_is_finite(v.y);
}

template <class T>
bool gloam_is_finite3(vec3<T> v) {
    return gloam_is_finite(v.x) && gloam_is_finite(v.y) && gloam_is_finite(v.z);
}

template <class T>
bool gloam_is_finite4(vec4<T> v) {
    return gloam_is_finite(v.x) && gloam_is_finite(v.y) && gloam_is_finite(v.z) && gloam_is_finite(v.w);
}

}  // namespace gloam::reference
