// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

namespace detail {

// A power of two that takes components up to `largest` to where their squares neither over- nor underflow.
template <class T>
T squarable_scale(T largest) {
    if (largest > T(4294967296.0)) return T(8.271806125530277e-25);
    return largest < T(2.3283064365386963e-10) ? T(1.2089258196146292e24) : T(1);
}

}  // namespace detail

template <class T>
vec3<T> gloam_safe_normalize(vec3<T> v, vec3<T> fallback) {
    if (!gloam_is_finite3(v)) return fallback;
    const T largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest >= float_min<T>())) return fallback;
    const vec3<T> scaled = v * detail::squarable_scale(largest);
    return scaled * inversesqrt(dot(scaled, scaled));
}

}  // namespace gloam::reference
