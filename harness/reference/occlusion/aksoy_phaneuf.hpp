// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/falloff.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_contribution_aksoy_phaneuf(dvec3 offset, dvec3 normal, double radius, double bias) {
    if (!is_finite(offset) || !(dot(offset, normal) > bias)) return 0.0;
    return gloam_falloff_linear(length(offset), radius);
}

inline double gloam_two_radii_sum(double fine, double broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), 1.0);
}

}  // namespace gloam::reference
