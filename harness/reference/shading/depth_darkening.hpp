// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_depth_darkening(double depth, double blurred_depth, double strength) {
    if (gloam_is_background(depth) || gloam_is_background(blurred_depth) || !(strength > 0.0)) return 0.0;
    return blurred_depth < depth ? max(strength * (blurred_depth - depth), -float_max) : 0.0;
}

}  // namespace gloam::reference
