// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_depth_bias(double bias, double depth, double reference_depth) {
    const bool known = bias > 0.0 && reference_depth >= float_min && reference_depth <= 0x1p126;
    return gloam_is_background(depth) || !known ? 0.0 : min(bias * depth / reference_depth, float_max);
}

}  // namespace gloam::reference
