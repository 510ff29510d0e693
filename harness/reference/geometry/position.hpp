// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T = double>
vec2<T> gloam_ndc_from_pixel(glm::ivec2 pixel, glm::ivec2 size) {
    if (size.x < 1 || size.y < 1) return vec2<T>(T(0), T(0));
    const auto axis = [](int p, int extent) { return (T(2) * T(p) + T(1) - T(extent)) / T(extent); };
    return vec2<T>(axis(pixel.x, size.x), axis(pixel.y, size.y));
}

template <class T>
vec2<T> gloam_uv_from_ndc(vec2<T> ndc) {
    if (!gloam_is_finite2(ndc)) return vec2<T>(T(2), T(2));
    return T(0.5) * ndc + T(0.5);
}

template <class T>
vec3<T> gloam_view_position_perspective(vec2<T> ndc, T depth, vec2<T> p00_p11) {
    const vec3<T> none(T(0), T(0), T(0));
    if (gloam_is_background(depth)) return none;
    const vec3<T> position(ndc.x / p00_p11.x * depth, ndc.y / p00_p11.y * depth, -depth);
    if (!gloam_is_finite3(position)) return none;
    return position;
}

template <class T>
vec3<T> gloam_view_position_orthographic(vec2<T> ndc, T depth, vec2<T> p00_p11) {
    const vec3<T> none(T(0), T(0), T(0));
    if (gloam_is_background(depth)) return none;
    const vec3<T> position(ndc.x / p00_p11.x, ndc.y / p00_p11.y, -depth);
    if (!gloam_is_finite3(position)) return none;
    return position;
}

template <class T>
vec2<T> gloam_ndc_perspective(vec3<T> view_position, vec2<T> p00_p11) {
    const vec2<T> outside(T(2), T(2));
    const T depth = -view_position.z;
    if (gloam_is_background(depth)) return outside;
    const vec2<T> ndc(p00_p11.x * view_position.x / depth, p00_p11.y * view_position.y / depth);
    if (!gloam_is_finite2(ndc)) return outside;
    return ndc;
}

template <class T>
vec2<T> gloam_ndc_orthographic(vec3<T> view_position, vec2<T> p00_p11) {
    const vec2<T> outside(T(2), T(2));
    if (gloam_is_background(-view_position.z)) return outside;
    const vec2<T> ndc(p00_p11.x * view_position.x, p00_p11.y * view_position.y);
    if (!gloam_is_finite2(ndc)) return outside;
    return ndc;
}

}  // namespace gloam::reference
