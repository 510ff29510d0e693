// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_geometry_weight(dvec3 normal, dvec3 other, double depth_difference, double normal_power,
                                    double position_power) {
    const double facing = 0.5 * dot(normal, other) + 0.5;
    const double apart = 1.0 + abs(depth_difference);
    if (!(facing > 0.0 && apart <= float_max && normal_power > 0.0 && position_power >= 0.0)) return 0.0;
    const double by_normal = facing < 1.0 ? normal_power * log2(facing) : 0.0;
    const double by_depth = apart > 1.0 ? position_power * log2(apart) : 0.0;
    const double x = by_normal - by_depth;
    const double weight = min(exp2(x), 1.0);
    return x >= -99.5 ? weight : 0.0;
}

}  // namespace gloam::reference
