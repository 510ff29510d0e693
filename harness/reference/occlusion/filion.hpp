// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/numeric/length_ratio.hpp"

namespace gloam::reference {

inline double gloam_contribution_filion(double sample_depth, double buffer_depth, double radius) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return 0.0;
    const double in_front = sample_depth - buffer_depth;
    if (!(in_front >= float_min && radius >= float_min)) return 0.0;
    return in_front <= radius ? 1.0 : gloam_length_ratio(radius, in_front);
}

}  // namespace gloam::reference
