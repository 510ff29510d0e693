// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline dvec3 gloam_neighbor_direction(dvec3 center, dvec3 behind, dvec3 ahead) {
    const bool has_behind = !gloam_is_background(-behind.z);
    const bool has_ahead = !gloam_is_background(-ahead.z);
    if (!has_behind && !has_ahead) return dvec3(0.0);
    const bool ahead_is_nearer = abs(ahead.z - center.z) <= abs(behind.z - center.z);
    const bool takes_ahead = has_ahead && (ahead_is_nearer || !has_behind);
    return gloam_safe_normalize(takes_ahead ? ahead - center : center - behind, dvec3(0.0));
}

inline dvec3 gloam_facing_normal(dvec3 along_x, dvec3 along_y, dvec3 toward_viewer) {
    const dvec3 span = cross(along_x, along_y);
    if (!(length(span) >= 1e-5 && length(span) <= 2.0)) return {0.0, 0.0, 1.0};
    return (dot(span, toward_viewer) < 0.0 ? -1.0 : 1.0) * normalize(span);
}

inline dvec3 gloam_normal_from_neighbors(dvec3 center, dvec3 left, dvec3 right, dvec3 up, dvec3 down) {
    if (gloam_is_background(-center.z)) return dvec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), -center);
}

inline dvec3 gloam_normal_from_neighbors_orthographic(dvec3 center, dvec3 left, dvec3 right, dvec3 up,
                                                      dvec3 down) {
    if (gloam_is_background(-center.z)) return dvec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), dvec3(0.0, 0.0, 1.0));
}

}  // namespace gloam::reference
