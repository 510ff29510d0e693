// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_positive_length(T x) {
    return x > T(0) ? (x <= float_max<T>() ? x : float_max<T>()) : T(0);
}

namespace detail {

template <class T>
vec2<T> positive_lengths(vec2<T> axes) {
    return vec2<T>(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
}

template <class T>
vec2<T> extent_of(glm::ivec2 size) {
    return vec2<T>(T(max(size.x, 0)), T(max(size.y, 0)));
}

}  // namespace detail

template <class T>
vec2<T> gloam_projected_radius_uv(T radius, T depth, vec2<T> p00_p11) {
    if (gloam_is_background(depth)) return vec2<T>(T(0), T(0));
    return detail::positive_lengths(vec2<T>(T(0.5) * abs(p00_p11) * (gloam_positive_length(radius) / depth)));
}

template <class T>
vec2<T> gloam_projected_radius_pixels(T radius, T depth, vec2<T> p00_p11, glm::ivec2 size) {
    return detail::positive_lengths(
        vec2<T>(gloam_projected_radius_uv(radius, depth, p00_p11) * detail::extent_of<T>(size)));
}

template <class T>
vec2<T> gloam_projected_radius_uv_orthographic(T radius, T depth, vec2<T> p00_p11) {
    if (gloam_is_background(depth)) return vec2<T>(T(0), T(0));
    return detail::positive_lengths(vec2<T>(T(0.5) * abs(p00_p11) * gloam_positive_length(radius)));
}

template <class T>
vec2<T> gloam_projected_radius_pixels_orthographic(T radius, T depth, vec2<T> p00_p11, glm::ivec2 size) {
    return detail::positive_lengths(
        vec2<T>(gloam_projected_radius_uv_orthographic(radius, depth, p00_p11) * detail::extent_of<T>(size)));
}

}  // namespace gloam::reference
