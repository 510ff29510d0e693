// SPDX-License-Identifier: MIT
#pragma once

#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_contribution_alchemy(dvec3 offset, dvec3 normal, double bias, double epsilon) {
    const double above = dot(offset, normal) - bias;
    const double denominator = dot(offset, offset) + epsilon;
    if (!(above > 0.0 && epsilon >= 0.0 && denominator >= float_min && denominator <= 0x1p126)) return 0.0;
    const double contribution = above / denominator;
    return contribution <= float_max ? contribution : 0.0;
}

inline double gloam_visibility_alchemy(dvec2 accumulated, double sigma, double k) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * sigma * (accumulated.x / accumulated.y), 0.0, 1.0, k);
}

}  // namespace gloam::reference
