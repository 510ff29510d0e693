// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_principal_curvatures(vec3<T> position_x, vec3<T> position_y, vec3<T> normal_x,
                                   vec3<T> normal_y) {
    const vec2<T> none(T(0), T(0));
    const T e = dot(position_x, position_x);
    const T g = dot(position_y, position_y);
    const vec3<T> span = cross(position_x, position_y);
    const T area2 = dot(span, span);
    const bool spanned =
        e >= T(1e-18) && g >= T(1e-18) && e <= T(1e18) && g <= T(1e18) && area2 > T(1e-8) * e * g;
    if (!spanned) return none;
    const T shear = dot(position_x, position_y) / e;
    const T l = -dot(position_x, normal_x);
    const T m = T(-0.5) * (dot(position_x, normal_y) + dot(position_y, normal_x)) - shear * l;
    const T n = -dot(position_y, normal_y) - shear * (T(2) * m + shear * l);
    const T a = l / e;
    const T b = n * (e / area2);
    const T c = m / gloam_sqrt(area2);
    const T half_difference = T(0.5) * (a - b);
    const T spread = gloam_sqrt(half_difference * half_difference + c * c);
    const vec2<T> curvatures(T(0.5) * (a + b) + spread, T(0.5) * (a + b) - spread);
    const bool finite = abs(curvatures.x) <= float_max<T>() && abs(curvatures.y) <= float_max<T>();
    return finite ? curvatures : none;
}

}  // namespace gloam::reference
