// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/length_ratio.hpp"
#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

inline double gloam_contribution_fox_compton(dvec3 position, dvec3 normal, dvec3 sample_position,
                                             double epsilon) {
    const dvec3 offset = sample_position - position;
    const double cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > 0.0 && epsilon <= float_max)) return 0.0;
    const double reach = dot(offset, gloam_safe_normalize(offset, dvec3(0.0)));
    return cosine / clamp(reach > epsilon ? reach : epsilon, float_min, 0x1p126);
}

inline double gloam_contribution_fox_compton_scaled(dvec3 position, dvec3 normal, dvec3 sample_position,
                                                    double epsilon) {
    const dvec3 offset = sample_position - position;
    const double cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > 0.0 && epsilon > 0.0)) return 0.0;
    const double reach = dot(offset, gloam_safe_normalize(offset, dvec3(0.0)));
    return reach > epsilon ? cosine * gloam_length_ratio(epsilon, reach) : cosine;
}

}  // namespace gloam::reference
