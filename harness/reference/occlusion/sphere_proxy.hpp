// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/numeric/length_ratio.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline double gloam_sphere_fraction(double radius, double distance_to) {
    if (!(radius > 0.0 && distance_to >= 0.0)) return 0.0;
    if (distance_to <= radius) return 1.0;
    const double x = gloam_length_ratio(radius, distance_to);
    const double gap = gloam_length_ratio(distance_to - radius, distance_to);
    return min(x * x / (1.0 + gloam_sqrt(gap * (1.0 + x))), 1.0);
}

inline double gloam_contribution_sphere(dvec3 offset, dvec3 normal, double radius) {
    if (!gloam_is_finite3(offset)) return 0.0;
    const double reach = gloam_length(offset);
    const double fraction = gloam_sphere_fraction(radius, reach);
    return reach <= radius ? fraction : fraction * gloam_sample_cosine(offset, normal);
}

inline double gloam_contribution_sphere_cosine(dvec3 offset, dvec3 normal, double radius) {
    if (!(gloam_is_finite3(offset) && radius > 0.0)) return 0.0;
    const double reach = gloam_length(offset);
    if (reach <= radius) return 1.0;
    const double x = gloam_length_ratio(radius, reach);
    return x * x * gloam_sample_cosine(offset, normal);
}

inline double gloam_above_horizon(dvec3 offset, double tan_horizon) {
    const double across = gloam_length(dvec3(offset.x, offset.y, 0.0));
    const double horizon = across > 0.0 ? across * tan_horizon : 0.0;
    return gloam_is_finite3(offset) && offset.z > horizon ? 1.0 : 0.0;
}

}  // namespace gloam::reference
