// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/sincos.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

template <class T>
T gloam_tangent_slope(vec2<T> direction, vec3<T> dpdu, vec3<T> dpdv) {
    const vec3<T> t =
        gloam_safe_normalize(dpdu * direction.x + dpdv * direction.y, vec3<T>(T(0), T(0), T(0)));
    const T across = gloam_sqrt(dot(vec2<T>(t.x, t.y), vec2<T>(t.x, t.y)));
    if (across > T(1e-6)) return clamp(t.z / across, T(-1e6), T(1e6));
    return t.z > T(0) ? T(1e6) : (t.z < T(0) ? T(-1e6) : T(0));
}

template <class T>
T gloam_sine_of_tangent(T tangent) {
    const T magnitude = abs(tangent);
    if (!(magnitude < T(1e6))) return tangent > T(0) ? T(1) : (tangent < T(0) ? T(-1) : T(0));
    return clamp(tangent * inversesqrt(T(1) + magnitude * magnitude), T(-1), T(1));
}

template <class T>
T gloam_tangent_elevation(vec3<T> normal, vec2<T> direction) {
    return clamp(gloam_atan2(-dot(vec2<T>(normal.x, normal.y), direction), normal.z), T(-1.570796327),
                 T(1.570796327));
}

template <class T>
vec2<T> gloam_hbao_start(T tangent, T bias) {
    const T elevation = tangent + bias;
    return vec2<T>(elevation < T(1.570796327) ? gloam_sincos(max(elevation, T(-1.570796327))).y : T(1), T(0));
}

// sin(atan(tan t + tan bias)) = x / (1 + x^2)^(1/2).
template <class T>
vec2<T> gloam_hbao_start_slope(T slope, T bias) {
    if (!(bias >= T(0) && bias < T(1.570796251F) && abs(slope) >= T(0))) return vec2<T>(T(1), T(0));
    const vec2<T> turned = gloam_sincos(bias);
    return vec2<T>(gloam_sine_of_tangent(slope + turned.y / turned.x), T(0));
}

template <class T>
vec2<T> gloam_hbao_step(vec2<T> horizon, vec3<T> offset, T radius) {
    const vec3<T> direction = gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0)));
    const T x = dot(offset, direction) / radius;
    const bool near =
        radius >= float_min<T>() && radius <= T(0x1p126) && x < T(1) && dot(direction, direction) > T(0.5);
    if (!(near && direction.z > horizon.x)) return horizon;
    const T sine = min(direction.z, T(1));
    return vec2<T>(sine, horizon.y + (sine - horizon.x) * (T(1) - x * x));
}

template <class T>
vec2<T> gloam_hbao_step_size(T radius, T largest, T steps, T extra) {
    const T reach = radius < largest ? radius : largest;
    if (!(reach >= T(1) && reach <= T(0x1p126) && steps >= T(1) && extra >= T(0))) return vec2<T>(T(0), T(0));
    const T count = floor(steps < reach ? steps : reach);
    return vec2<T>(reach / (count + extra), count);
}

template <class T>
T gloam_hbao_visibility(T occlusion, T bias, T contrast) {
    const T rest = T(1) - gloam_sincos(bias).y;
    if (!(abs(bias) < T(1.5) && occlusion > T(0) && contrast > T(0))) return T(1);
    const T visibility = T(1) - contrast * (occlusion / rest);
    return visibility > T(0) ? visibility : (visibility <= T(0) ? T(0) : T(1));
}

template <class T>
T gloam_contribution_hbao_simplified(vec3<T> offset, vec3<T> normal, T radius, T bias) {
    const vec3<T> direction = gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0)));
    const T x = dot(offset, direction) / radius;
    const T above = dot(normal, direction) - bias;
    const bool near = radius >= float_min<T>() && radius <= T(0x1p126) && x < T(1);
    if (!(near && above > T(0) && bias >= T(0) && bias < T(1))) return T(0);
    return min(above / (T(1) - bias), T(1)) * (T(1) - x * x);
}

template <class T>
T gloam_visibility_hbao_simplified(vec2<T> accumulated, T power) {
    if (!(accumulated.y >= T(1) && accumulated.x > T(0))) return T(1);
    return gloam_remap(T(1) - T(2) * (accumulated.x / accumulated.y), T(0), T(1), power);
}

}  // namespace gloam::reference
