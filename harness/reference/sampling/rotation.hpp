// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_rotate_disc(vec2<T> s, T angle) {
    if (!(dot(s, s) <= T(1e38))) return vec2<T>(T(0), T(0));
    const vec2<T> r = gloam_sincos(angle);
    return vec2<T>(r.x * s.x - r.y * s.y, r.y * s.x + r.x * s.y);
}

template <class T>
vec3<T> gloam_rotate_hemisphere(vec3<T> s, T angle) {
    if (!(dot(s, s) <= T(1e38))) return vec3<T>(T(0), T(0), T(0));
    const vec2<T> side = gloam_rotate_disc(vec2<T>(s.x, s.y), angle);
    return vec3<T>(side.x, side.y, s.z);
}

}  // namespace gloam::reference
