// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_geometry_weight(dvec3 normal, dvec3 other, double depth_difference, double normal_power,
                                    double position_power) {
    const double facing = min(dot(normal, other) / 2.0 + 0.5, 1.0);
    if (!(facing > 0.0 && is_finite(depth_difference) && normal_power > 0.0 && position_power >= 0.0))
        return 0.0;
    return pow(facing, normal_power) * pow(1.0 + abs(depth_difference), -position_power);
}

}  // namespace gloam::reference
