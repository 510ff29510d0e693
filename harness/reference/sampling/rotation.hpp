// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_wrap_angle(T angle) {
    if (!(abs(angle) <= T(65536))) return T(0);
    if constexpr (exact_number<T>) {
        const T turn = T(2) * pi<T>();
        return angle - turn * floor(angle / turn + T(0.5));
    }
    const T turns = floor(angle * T(0.159154943) + T(0.5));
    T rest = ((angle - turns * T(6.28125)) - turns * T(0.001934051513671875)) - turns * T(1.255665915e-6);
    if (rest > T(3.141592503)) {
        rest = rest - T(6.283185307);
    } else if (rest < T(-3.141592503)) {
        rest = rest + T(6.283185307);
    }
    return clamp(rest, T(-3.141592503), T(3.141592503));
}

template <class T>
vec2<T> gloam_rotate_disc(vec2<T> s, T angle) {
    if (!(dot(s, s) <= T(1e38))) return vec2<T>(T(0), T(0));
    const T wrapped = gloam_wrap_angle(angle);
    const T c = cos(wrapped);
    const T d = sin(wrapped);
    return vec2<T>(c * s.x - d * s.y, d * s.x + c * s.y);
}

template <class T>
vec3<T> gloam_rotate_hemisphere(vec3<T> s, T angle) {
    if (!(dot(s, s) <= T(1e38))) return vec3<T>(T(0), T(0), T(0));
    const vec2<T> side = gloam_rotate_disc(vec2<T>(s.x, s.y), angle);
    return vec3<T>(side.x, side.y, s.z);
}

}  // namespace gloam::reference
