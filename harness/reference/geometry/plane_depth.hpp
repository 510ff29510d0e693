// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"

namespace gloam::reference {

// n . (o + t w - q) = 0 with the ray's origin o and direction w, w.z = -1, so that t is the depth.
inline double gloam_plane_depth(glm::ivec2 pixel, dvec3 point, dvec3 normal, const GloamCamera& camera) {
    if (gloam_is_background(-point.z)) return infinity;
    const dvec3 seen = gloam_camera_position(pixel, 1.0, camera);
    const dvec3 origin = camera.orthographic ? dvec3(seen.x, seen.y, 0.0) : dvec3(0.0);
    const double facing = dot(normal, seen - origin);
    const double t = dot(normal, point - origin) / facing;
    return facing < 0.0 && !gloam_is_background(t) ? t : -point.z;
}

}  // namespace gloam::reference
