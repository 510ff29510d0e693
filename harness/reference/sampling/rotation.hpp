// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_turn_disc(vec2<T> s, vec2<T> turn) {
    if (!(dot(s, s) <= T(1e38))) return vec2<T>(T(0), T(0));
    return vec2<T>(turn.x * s.x - turn.y * s.y, turn.y * s.x + turn.x * s.y);
}

template <class T>
vec3<T> gloam_turn_hemisphere(vec3<T> s, vec2<T> turn) {
    if (!(dot(s, s) <= T(1e38))) return vec3<T>(T(0), T(0), T(0));
    const vec2<T> side = gloam_turn_disc(vec2<T>(s.x, s.y), turn);
    return vec3<T>(side.x, side.y, s.z);
}

template <class T>
vec2<T> gloam_rotate_disc(vec2<T> s, T angle) {
    return gloam_turn_disc(s, gloam_sincos(angle));
}

template <class T>
vec3<T> gloam_rotate_hemisphere(vec3<T> s, T angle) {
    return gloam_turn_hemisphere(s, gloam_sincos(angle));
}

}  // namespace gloam::reference
