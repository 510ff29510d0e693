// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"
#include "reference/occlusion/falloff.hpp"

namespace gloam::reference {

inline double gloam_contribution_mssao(dvec3 offset, dvec3 normal, double radius) {
    return gloam_falloff_quadratic(gloam_length(offset), radius) * gloam_sample_cosine(offset, normal);
}

inline double gloam_mssao_combine(double largest, double mean) {
    return 1.0 - (1.0 - gloam_unit_interval(largest)) * (1.0 - gloam_unit_interval(mean));
}

}  // namespace gloam::reference
