// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/camera.hpp"
#include "reference/geometry/position.hpp"
#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_plane_depth(glm::ivec2 pixel, dvec3 point, dvec3 normal, GloamCamera camera) {
    if (gloam_is_background(-point.z)) return gloam_background_depth();
    const dvec3 ray = gloam_camera_position(pixel, 1.0, camera);
    dvec3 start(0.0);
    if (camera.orthographic) start = dvec3(ray.x, ray.y, 0.0);
    const double along = dot(normal, ray - start);
    const double depth = dot(normal, point - start) / (along < 0.0 ? along : -1.0);
    return along < 0.0 && !gloam_is_background(depth) ? depth : -point.z;
}

}  // namespace gloam::reference
