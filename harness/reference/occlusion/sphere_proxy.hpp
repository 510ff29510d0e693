// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline double gloam_sphere_fraction(double radius, double distance_to) {
    if (!(radius > 0.0 && distance_to >= 0.0)) return 0.0;
    return distance_to <= radius ? 1.0 : 1.0 - sqrt(1.0 - pow(radius / distance_to, 2));
}

inline double gloam_contribution_sphere(dvec3 offset, dvec3 normal, double radius) {
    if (!is_finite(offset)) return 0.0;
    const double cosine = gloam_length(offset) <= radius ? 1.0 : gloam_sample_cosine(offset, normal);
    return gloam_sphere_fraction(radius, gloam_length(offset)) * cosine;
}

inline double gloam_contribution_sphere_cosine(dvec3 offset, dvec3 normal, double radius) {
    if (!is_finite(offset) || !(radius > 0.0)) return 0.0;
    const double d = gloam_length(offset);
    return d <= radius ? 1.0 : pow(radius / d, 2) * gloam_sample_cosine(offset, normal);
}

inline double gloam_above_horizon(dvec3 offset, double tan_horizon) {
    const double across = gloam_length(dvec3(offset.x, offset.y, 0.0));
    const double horizon = across > 0.0 ? tan_horizon * across : 0.0;
    return is_finite(offset) && offset.z > horizon ? 1.0 : 0.0;
}

}  // namespace gloam::reference
