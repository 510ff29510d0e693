// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/visibility.hpp"

namespace gloam::reference {

inline double gloam_quad_box(double visibility, double difference, double depth_difference, int coordinate,
                             double edge) {
    const bool smooth_here = abs(depth_difference) < edge && abs(difference) <= float_max;
    const double side = (coordinate & 1) == 1 ? 0.5 : -0.5;
    return gloam_visibility_clamp(smooth_here ? visibility - difference * side : visibility);
}

}  // namespace gloam::reference
