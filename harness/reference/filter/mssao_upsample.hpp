// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_mssao_upsample_weight(double bilinear, double depth_difference, double normal_cosine,
                                          double depth_power, double normal_power) {
    const double apart = abs(depth_difference);
    const bool known =
        apart <= 1e30 && abs(normal_cosine) >= 0.0 && depth_power >= 0.0 && normal_power >= 0.0;
    if (!known) return 0.0;
    const double depth = gloam_remap(1.0 / (1.0 + apart), 0.0, 1.0, depth_power);
    const double facing = gloam_unit_interval(0.5 * normal_cosine + 0.5);
    const double normal = gloam_remap(facing, 0.0, 1.0, normal_power);
    return gloam_unit_interval(bilinear) * depth * normal;
}

}  // namespace gloam::reference
