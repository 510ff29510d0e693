// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/visibility.hpp"

namespace gloam::reference {

inline double gloam_quad_box(double visibility, double difference, double depth_difference, int coordinate,
                             double edge) {
    const bool edge_between = !(abs(depth_difference) < edge) || !is_finite(difference);
    const double part = edge_between ? 0.0 : difference * ((coordinate & 1) - 0.5);
    return gloam_visibility_clamp(visibility - part);
}

}  // namespace gloam::reference
