// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

inline int gloam_count_by_distance(double depth, double z_far, int base, int least) {
    const double start = double(std::clamp(base, 0, 4096));
    const bool placed = depth >= 0.0 && z_far >= float_min && depth < z_far;
    const double distance_part = placed ? (z_far <= 0x1p126 ? depth / z_far : 0.0) : 1.0;
    return std::max(int(start / (1.0 + start * distance_part)), least);
}

}  // namespace gloam::reference
