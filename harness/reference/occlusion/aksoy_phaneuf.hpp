// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_contribution_aksoy_phaneuf(dvec3 offset, dvec3 normal, double radius, double bias) {
    const bool in_front = gloam_is_finite3(offset) && dot(offset, normal) > bias;
    return in_front ? gloam_falloff_linear(gloam_length(offset), radius) : 0.0;
}

inline double gloam_two_radii_sum(double fine, double broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), 1.0);
}

}  // namespace gloam::reference
