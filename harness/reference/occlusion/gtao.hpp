// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
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
vec2<T> gloam_gtao_lowest(T angle) {
    const T sine = gloam_sincos(angle).y;
    return vec2<T>(sine, -sine);
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
T gloam_gtao_arc(T elevation, T angle) {
    const T e = elevation > T(0) ? min(elevation, T(3.141592654)) : T(0);
    const T arc = T(0.5) * (e * gloam_sincos(angle).y + gloam_sincos(e - angle).y * gloam_sincos(e).y);
    return arc > T(0) ? min(arc, T(1.570796327)) : T(0);
}

template <class T>
T gloam_gtao_arc_uniform(T elevation, T angle) {
    const T part = elevation > T(0) ? T(0.5) * min(elevation, T(3.141592654)) : T(0);
    const T arc = gloam_sincos(part).y * gloam_sincos(angle - part).x;
    return arc > T(0) ? min(arc, T(1)) : T(0);
}

template <class T>
vec2<T> gloam_gtao_add(vec2<T> accumulated, T weight, vec2<T> elevations, T angle) {
    if (!(weight > T(0) && weight <= float_max<T>() && abs(angle) <= T(1.6))) return accumulated;
    const vec2<T> n = gloam_sincos(angle);
    const T occluded = gloam_gtao_arc(elevations.x, -angle) + gloam_gtao_arc(elevations.y, angle);
    return accumulated + vec2<T>(occluded, n.x + angle * n.y) * weight;
}

template <class T>
vec2<T> gloam_gtao_add_uniform(vec2<T> accumulated, vec2<T> elevations, T angle) {
    if (!(abs(angle) <= T(1.6))) return accumulated;
    const T occluded =
        gloam_gtao_arc_uniform(elevations.x, -angle) + gloam_gtao_arc_uniform(elevations.y, angle);
    return accumulated + vec2<T>(occluded, T(1));
}

template <class T>
T gloam_gtao_occlusion(vec2<T> accumulated) {
    if (!(accumulated.x > T(0) && accumulated.y >= float_min<T>() && accumulated.y <= T(0x1p126)))
        return T(0);
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, T(1)) : T(1);
}

}  // namespace gloam::reference
