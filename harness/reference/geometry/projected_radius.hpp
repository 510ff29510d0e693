// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_positive_length(T x) {
    if (x > float_max<T>()) return float_max<T>();
    if (x > T(0)) return x;
    return T(0);
}

namespace detail {

// Half-axes of a length seen at a magnification, in units of an image `extent` wide.
template <class T>
vec2<T> seen_length(T radius, vec2<T> magnification, vec2<T> extent) {
    const T r = gloam_positive_length(radius);
    const auto axis = [&](T m, T e) {
        return gloam_positive_length(gloam_positive_length(r * abs(m) / T(2)) * e);
    };
    return vec2<T>(axis(magnification.x, extent.x), axis(magnification.y, extent.y));
}

template <class T>
vec2<T> positive_extent(glm::ivec2 size) {
    return vec2<T>(T(size.x > 0 ? size.x : 0), T(size.y > 0 ? size.y : 0));
}

}  // namespace detail

template <class T>
vec2<T> gloam_projected_radius_uv(T radius, T depth, vec2<T> p00_p11) {
    if (gloam_is_background(depth)) return vec2<T>(T(0), T(0));
    return detail::seen_length(radius, p00_p11 / depth, vec2<T>(T(1), T(1)));
}

template <class T>
vec2<T> gloam_projected_radius_pixels(T radius, T depth, vec2<T> p00_p11, glm::ivec2 size) {
    if (gloam_is_background(depth)) return vec2<T>(T(0), T(0));
    return detail::seen_length(radius, p00_p11 / depth, detail::positive_extent<T>(size));
}

template <class T>
vec2<T> gloam_projected_radius_uv_orthographic(T radius, T depth, vec2<T> p00_p11) {
    if (gloam_is_background(depth)) return vec2<T>(T(0), T(0));
    return detail::seen_length(radius, p00_p11, vec2<T>(T(1), T(1)));
}

template <class T>
vec2<T> gloam_projected_radius_pixels_orthographic(T radius, T depth, vec2<T> p00_p11, glm::ivec2 size) {
    if (gloam_is_background(depth)) return vec2<T>(T(0), T(0));
    return detail::seen_length(radius, p00_p11, detail::positive_extent<T>(size));
}

}  // namespace gloam::reference
