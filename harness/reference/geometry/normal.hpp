// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline dvec3 gloam_neighbor_direction(dvec3 center, dvec3 behind, dvec3 ahead) {
    const dvec3 zero(0.0);
    const bool has_behind = !gloam_is_background(-behind.z);
    const bool has_ahead = !gloam_is_background(-ahead.z);
    if (!has_behind && !has_ahead) return zero;
    const bool ahead_closer = abs(ahead.z - center.z) <= abs(center.z - behind.z);
    const bool use_ahead = has_ahead && (!has_behind || ahead_closer);
    return gloam_safe_normalize(use_ahead ? ahead - center : center - behind, zero);
}

inline dvec3 gloam_facing_normal(dvec3 along_x, dvec3 along_y, dvec3 toward_viewer) {
    dvec3 normal = cross(along_x, along_y);
    const double squared = dot(normal, normal);
    if (!(squared >= 1e-10 && squared <= 4.0)) return dvec3(0.0, 0.0, 1.0);
    normal = normal / sqrt(squared);
    return dot(normal, toward_viewer) < 0.0 ? -normal : normal;
}

inline dvec3 gloam_normal_from_neighbors(dvec3 center, dvec3 left, dvec3 right, dvec3 up, dvec3 down) {
    if (gloam_is_background(-center.z)) return dvec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), dvec3(-center));
}

inline dvec3 gloam_normal_from_neighbors_orthographic(dvec3 center, dvec3 left, dvec3 right, dvec3 up,
                                                      dvec3 down) {
    if (gloam_is_background(-center.z)) return dvec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), dvec3(0.0, 0.0, 1.0));
}

}  // namespace gloam::reference
