// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/camera.hpp"
#include "reference/geometry/position.hpp"
#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_plane_depth(glm::ivec2 pixel, vec3<T> point, vec3<T> normal, GloamCamera<T> camera) {
    if (gloam_is_background(T(-point.z))) return gloam_background_depth<T>();
    const vec3<T> ray = gloam_camera_position(pixel, T(1), camera);
    vec3<T> start(T(0), T(0), T(0));
    if (camera.orthographic) start = vec3<T>(ray.x, ray.y, T(0));
    const T along = dot(normal, ray - start);
    const T depth = dot(normal, point - start) / (along < T(0) ? along : T(-1));
    return along < T(0) && !gloam_is_background(depth) ? depth : T(-point.z);
}

}  // namespace gloam::reference
