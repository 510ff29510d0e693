// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_sincos_octant(T angle) {
    if constexpr (exact_number<T>) return vec2<T>(cos(angle), sin(angle));
    const T z = angle * angle;
    const T c =
        (T(1) - T(0.5) * z) + (z * z) * (T(0.0416666456) + z * (T(-0.00138873677) + z * T(2.44384519e-05)));
    const T s = angle + (angle * z) * (T(-0.166666552) + z * (T(0.0083321603) + z * T(-0.000195152839)));
    return vec2<T>(c, s);
}

template <class T>
vec2<T> gloam_quarter_turn(vec2<T> v, int quarters) {
    const vec2<T> turned = (quarters & 1) != 0 ? vec2<T>(-v.y, v.x) : v;
    return (quarters & 2) != 0 ? vec2<T>(-turned) : turned;
}

template <class T>
vec2<T> gloam_sincos_turns(T turns) {
    const T magnitude = abs(turns) <= float_max<T>() ? abs(turns) : T(0);
    const T part = magnitude - floor(magnitude);
    const int quarters = (to_int(part * T(8)) + 1) >> 1;
    const T rest = part - T(0.25) * T(quarters);
    const T angle = exact_number<T> ? rest * T(2) * pi<T>() : rest * T(6.283185307);
    const vec2<T> p = gloam_quarter_turn(gloam_sincos_octant(angle), quarters);
    return vec2<T>(p.x, turns < T(0) ? -p.y : p.y);
}

template <class T>
vec2<T> gloam_sincos(T angle) {
    const T a = abs(angle) <= T(65536) ? angle : T(0);
    if constexpr (exact_number<T>) return vec2<T>(cos(a), sin(a));
    const T quarters = floor(a * T(0.636619772) + T(0.5));
    const T rest = ((a - quarters * T(1.5703125)) - quarters * T(0.0004825592041015625)) -
                   quarters * T(1.26759079506e-6);
    return gloam_quarter_turn(gloam_sincos_octant(rest), to_int(quarters));
}

}  // namespace gloam::reference
