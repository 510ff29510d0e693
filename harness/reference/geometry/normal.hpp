// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_neighbor_direction(vec3<T> center, vec3<T> behind, vec3<T> ahead) {
    const vec3<T> zero(T(0), T(0), T(0));
    const bool has_behind = !gloam_is_background(T(-behind.z));
    const bool has_ahead = !gloam_is_background(T(-ahead.z));
    if (!has_behind && !has_ahead) return zero;
    const bool ahead_closer = abs(ahead.z - center.z) <= abs(center.z - behind.z);
    const bool use_ahead = has_ahead && (!has_behind || ahead_closer);
    return gloam_safe_normalize(use_ahead ? ahead - center : center - behind, zero);
}

template <class T>
vec3<T> gloam_facing_normal(vec3<T> along_x, vec3<T> along_y, vec3<T> toward_viewer) {
    vec3<T> normal = cross(along_x, along_y);
    const T squared = dot(normal, normal);
    if (!(squared >= T(1e-10) && squared <= T(4))) return vec3<T>(T(0), T(0), T(1));
    normal = normal * inversesqrt(squared);
    return dot(normal, toward_viewer) < T(0) ? -normal : normal;
}

template <class T>
vec3<T> gloam_normal_from_neighbors(vec3<T> center, vec3<T> left, vec3<T> right, vec3<T> up, vec3<T> down) {
    if (gloam_is_background(T(-center.z))) return vec3<T>(T(0), T(0), T(0));
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), vec3<T>(-center));
}

template <class T>
vec3<T> gloam_normal_from_neighbors_orthographic(vec3<T> center, vec3<T> left, vec3<T> right, vec3<T> up,
                                                 vec3<T> down) {
    if (gloam_is_background(T(-center.z))) return vec3<T>(T(0), T(0), T(0));
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), vec3<T>(T(0), T(0), T(1)));
}

}  // namespace gloam::reference
