// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_contribution_mssao(dvec3 offset, dvec3 normal, double radius) {
    return gloam_falloff_quadratic(gloam_length(offset), radius) * gloam_sample_cosine(offset, normal);
}

inline double gloam_mssao_combine(double largest, double mean) {
    const double a = gloam_unit_interval(largest);
    const double b = gloam_unit_interval(mean);
    return min(a + b * (1.0 - a), 1.0);
}

}  // namespace gloam::reference
