// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_depth_bias(double bias, double depth, double reference_depth) {
    if (gloam_is_background(depth) ||
        !(bias > 0.0 && reference_depth >= float_min && reference_depth <= 0x1p126))
        return 0.0;
    const double scaled = bias * (depth / reference_depth);
    return scaled <= float_max ? scaled : (scaled > 0.0 ? float_max : 0.0);
}

}  // namespace gloam::reference
