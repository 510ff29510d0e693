// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

inline double gloam_chord_half_height(dvec2 xi, double radius) {
    const double height = radius * gloam_sqrt(1.0 - dot(xi, xi));
    return height > 0.0 ? height : 0.0;
}

inline double gloam_line_occlusion(double height, double half_height) {
    if (!(half_height >= float_min && half_height <= 0x1p126)) return 0.5;
    if (height >= half_height) return 1.0;
    if (height <= -half_height) return 0.0;
    return abs(height) < half_height ? 0.5 + 0.5 * (height / half_height) : 0.5;
}

// The place of the surface on a line from the far end (0) of the chord to its near end (1).
inline double gloam_line_ratio(double height, double half_height) {
    if (!(half_height >= float_min && half_height <= 0x1p126)) return 0.5;
    const double ratio = 0.5 + 0.5 * (height / half_height);
    return abs(ratio) >= 0.0 ? ratio : 0.5;
}

inline dvec2 gloam_line_pair(dvec2 ratios, double lowest, double highest) {
    const bool first = ratios.x >= lowest && ratios.x <= highest;
    const bool second = ratios.y >= lowest && ratios.y <= highest;
    if (first && second) return ratios;
    if (first) return dvec2(ratios.x, 1.0 - ratios.x);
    return second ? dvec2(1.0 - ratios.y, ratios.y) : dvec2(0.5, 0.5);
}

inline double gloam_tangent_sphere_half_height(dvec3 offset, dvec3 normal, double radius) {
    if (!(radius >= float_min && radius <= 0x1p126)) return 0.0;
    const double half_radius = 0.5 * radius;
    const dvec2 xi = dvec2(offset.x, offset.y) / half_radius - dvec2(normal.x, normal.y);
    const double height = half_radius * gloam_sqrt(1.0 - dot(xi, xi));
    return height > 0.0 ? height : 0.0;
}

inline double gloam_tangent_sphere_occlusion(dvec3 offset, dvec3 normal, double radius) {
    const double half_height = gloam_tangent_sphere_half_height(offset, normal, radius);
    const double height = offset.z - 0.5 * radius * normal.z;
    return half_height >= float_min && abs(height) >= 0.0 ? gloam_line_occlusion(height, half_height) : 0.0;
}

}  // namespace gloam::reference
