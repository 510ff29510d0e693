// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline double gloam_contribution_fox_compton(dvec3 position, dvec3 normal, dvec3 sample_position,
                                             double epsilon) {
    const dvec3 offset = sample_position - position;
    if (!(epsilon <= float_max) || !has_direction(offset)) return 0.0;
    return gloam_sample_cosine(offset, normal) / std::clamp(max(epsilon, length(offset)), float_min, 0x1p126);
}

inline double gloam_contribution_fox_compton_scaled(dvec3 position, dvec3 normal, dvec3 sample_position,
                                                    double epsilon) {
    const dvec3 offset = sample_position - position;
    if (!(epsilon > 0.0) || !has_direction(offset)) return 0.0;
    const double share = length(offset) > epsilon ? epsilon / length(offset) : 1.0;
    return gloam_sample_cosine(offset, normal) * share;
}

}  // namespace gloam::reference
