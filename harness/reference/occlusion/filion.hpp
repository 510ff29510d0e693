// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/occlusion/falloff.hpp"

namespace gloam::reference {

inline double gloam_contribution_filion(double sample_depth, double buffer_depth, double radius) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return 0.0;
    return 1.0 - gloam_visibility_filion(sample_depth - buffer_depth, radius);
}

}  // namespace gloam::reference
