// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_sample_blocked(double sample_depth, double buffer_depth, double bias, double range) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return 0.0;
    const double in_front = sample_depth - buffer_depth;
    return in_front > bias && in_front <= range ? 1.0 : 0.0;
}

}  // namespace gloam::reference
