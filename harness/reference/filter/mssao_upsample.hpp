// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_mssao_upsample_weight(double bilinear, double depth_difference, double normal_cosine,
                                          double depth_power, double normal_power) {
    const bool known = abs(depth_difference) <= 1e30 && !std::isnan(normal_cosine);
    if (!known || !(depth_power >= 0.0 && normal_power >= 0.0)) return 0.0;
    return gloam_unit_interval(bilinear) * pow(1.0 / (1.0 + abs(depth_difference)), depth_power) *
           pow((glm::clamp(normal_cosine, -1.0, 1.0) + 1.0) / 2.0, normal_power);
}

}  // namespace gloam::reference
