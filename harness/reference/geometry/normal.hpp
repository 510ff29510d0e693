// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_neighbor_direction(vec3<T> center, vec3<T> behind, vec3<T> ahead) {
    const vec3<T> zero(T(0), T(0), T(0));
    const bool no_behind = gloam_is_background(-behind.z);
    const bool no_ahead = gloam_is_background(-ahead.z);
    if (no_behind && no_ahead) return zero;
    const vec3<T> forward = gloam_safe_normalize(ahead - center, zero);
    const vec3<T> backward = gloam_safe_normalize(center - behind, zero);
    if (no_ahead) return backward;
    if (no_behind) return forward;
    if (abs(ahead.z - center.z) <= abs(behind.z - center.z)) return forward;
    return backward;
}

template <class T>
vec3<T> gloam_facing_normal(vec3<T> along_x, vec3<T> along_y, vec3<T> toward_viewer) {
    const vec3<T> product = cross(along_x, along_y);
    const T squared = dot(product, product);
    if (!(squared >= T(1e-10) && squared <= T(4))) return vec3<T>(T(0), T(0), T(1));
    const vec3<T> normal = normalize(product);
    if (dot(normal, toward_viewer) < T(0)) return -normal;
    return normal;
}

namespace detail {

template <class T>
vec3<T> normal_toward(vec3<T> center, vec3<T> left, vec3<T> right, vec3<T> up, vec3<T> down, vec3<T> viewer) {
    if (gloam_is_background(-center.z)) return vec3<T>(T(0), T(0), T(0));
    const vec3<T> x = gloam_neighbor_direction(center, left, right);
    const vec3<T> y = gloam_neighbor_direction(center, down, up);
    return gloam_facing_normal(x, y, viewer);
}

}  // namespace detail

template <class T>
vec3<T> gloam_normal_from_neighbors(vec3<T> center, vec3<T> left, vec3<T> right, vec3<T> up, vec3<T> down) {
    return detail::normal_toward(center, left, right, up, down, -center);
}

template <class T>
vec3<T> gloam_normal_from_neighbors_orthographic(vec3<T> center, vec3<T> left, vec3<T> right, vec3<T> up,
                                                 vec3<T> down) {
    return detail::normal_toward(center, left, right, up, down, vec3<T>(T(0), T(0), T(1)));
}

}  // namespace gloam::reference
