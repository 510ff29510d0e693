// SPDX-License-Identifier: MIT
#pragma once

#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_contribution_alchemy(dvec3 offset, dvec3 normal, double bias, double epsilon) {
    const double divisor = dot(offset, offset) + epsilon;
    if (!(epsilon >= 0.0 && divisor >= float_min && divisor <= 0x1p126)) return 0.0;
    const double above = dot(offset, normal) - bias;
    return above > 0.0 && is_finite(above / divisor) ? above / divisor : 0.0;
}

inline double gloam_visibility_alchemy(dvec2 accumulated, double sigma, double k) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * sigma / accumulated.y * accumulated.x, 0.0, 1.0, k);
}

}  // namespace gloam::reference
