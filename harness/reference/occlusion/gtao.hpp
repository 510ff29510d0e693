// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

template <class T>
T gloam_gtao_horizon(T horizon, T lowest, vec3<T> offset, vec3<T> view, T weight) {
    const vec3<T> direction = gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0)));
    if (!(weight > T(0) && dot(direction, direction) > T(0.5))) return horizon;
    const T cosine = lowest + (dot(direction, view) - lowest) * min(weight, T(1));
    return cosine > horizon ? min(cosine, T(1)) : horizon;
}

template <class T>
vec2<T> gloam_gtao_lowest(GloamSlice<T> slice) {
    return vec2<T>(slice.normal.y, -slice.normal.y);
}

template <class T>
T gloam_gtao_elevation(T horizon, T angle) {
    const T e = T(1.570796327) + angle - gloam_acos(horizon);
    return e > T(0) ? min(e, T(3.141592654)) : T(0);
}

template <class T>
T gloam_gtao_inner(T horizon, T angle) {
    const vec2<T> n = gloam_sincos(angle);
    const T visible = T(0.25) * (n.x - gloam_sincos(T(2) * horizon - angle).x + T(2) * horizon * n.y);
    return visible > T(0) ? min(visible, T(1.570796327)) : T(0);
}

template <class T>
T gloam_gtao_arc(T elevation, vec2<T> horizon, vec2<T> normal) {
    if (!(elevation > T(0))) return T(0);
    const T arc = T(0.5) * (min(elevation, T(3.141592654)) * normal.y + horizon.x * dot(horizon, normal));
    return arc > T(0) ? min(arc, T(1.570796327)) : T(0);
}

template <class T>
T gloam_gtao_arc_uniform(T horizon, T sine) {
    const T arc = T(0.5) * (sine + horizon);
    return arc > T(0) ? min(arc, T(1)) : T(0);
}

template <class T>
T gloam_gtao_side(T horizon, T angle, vec2<T> normal) {
    const T c = horizon > T(-1) ? min(horizon, T(1)) : T(-1);
    const T s = gloam_sqrt((T(1) - c) * (T(1) + c));
    return gloam_gtao_arc(gloam_gtao_elevation(c, angle), vec2<T>(c, s), normal);
}

template <class T>
vec2<T> gloam_gtao_add(vec2<T> accumulated, GloamSlice<T> slice, vec2<T> horizons) {
    if (!(slice.weight > T(0) && slice.weight <= float_max<T>())) return accumulated;
    const T occluded =
        gloam_gtao_side(horizons.x, T(-slice.angle), vec2<T>(slice.normal.x, -slice.normal.y)) +
        gloam_gtao_side(horizons.y, slice.angle, slice.normal);
    return accumulated + vec2<T>(occluded, gloam_slice_whole(slice)) * slice.weight;
}

template <class T>
vec2<T> gloam_gtao_add_uniform(vec2<T> accumulated, GloamSlice<T> slice, vec2<T> horizons) {
    if (!(slice.weight > T(0))) return accumulated;
    const T occluded = gloam_gtao_arc_uniform(horizons.x, T(-slice.normal.y)) +
                       gloam_gtao_arc_uniform(horizons.y, slice.normal.y);
    return accumulated + vec2<T>(occluded, T(1));
}

template <class T>
T gloam_gtao_occlusion(vec2<T> accumulated) {
    if (!(accumulated.x > T(0) && accumulated.y >= float_min<T>() && accumulated.y <= T(0x1p126)))
        return T(0);
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, T(1)) : T(1);
}

}  // namespace gloam::reference
