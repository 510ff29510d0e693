// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_wrap_angle(T angle) {
    if (!(abs(angle) <= T(65536))) return T(0);
    const T turn = T(2) * pi<T>();
    return angle - turn * floor(angle / turn + T(0.5));
}

template <class T>
vec2<T> gloam_rotate_disc(vec2<T> s, T angle) {
    if (!(dot(s, s) <= T(1e38))) return vec2<T>(T(0), T(0));
    const T phi = gloam_wrap_angle(angle);
    return vec2<T>(cos(phi) * s.x - sin(phi) * s.y, sin(phi) * s.x + cos(phi) * s.y);
}

template <class T>
vec3<T> gloam_rotate_hemisphere(vec3<T> s, T angle) {
    if (!(dot(s, s) <= T(1e38))) return vec3<T>(T(0), T(0), T(0));
    const T phi = gloam_wrap_angle(angle);
    return vec3<T>(cos(phi) * s.x - sin(phi) * s.y, sin(phi) * s.x + cos(phi) * s.y, s.z);
}

}  // namespace gloam::reference
