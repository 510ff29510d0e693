// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/camera.hpp"
#include "reference/geometry/position.hpp"
#include "reference/math.hpp"

namespace gloam::reference {

// n . (o + t w - q) = 0 with the ray's origin o and direction w, w.z = -1, so that t is the depth.
template <class T>
T gloam_plane_depth(glm::ivec2 pixel, vec3<T> point, vec3<T> normal, GloamCamera<T> camera) {
    if (gloam_is_background(T(-point.z))) return gloam_background_depth<T>();
    const vec2<T> ndc = gloam_ndc_from_pixel<T>(pixel, camera.size);
    const vec2<T> side(ndc.x / camera.p00_p11.x, ndc.y / camera.p00_p11.y);
    const vec3<T> origin = camera.orthographic ? vec3<T>(side.x, side.y, T(0)) : vec3<T>(T(0));
    const vec3<T> direction =
        camera.orthographic ? vec3<T>(T(0), T(0), T(-1)) : vec3<T>(side.x, side.y, T(-1));
    const T facing = dot(normal, direction);
    if (!(facing < T(0))) return -point.z;
    const T depth = (dot(normal, point) - dot(normal, origin)) / facing;
    return gloam_is_background(depth) ? T(-point.z) : depth;
}

}  // namespace gloam::reference
