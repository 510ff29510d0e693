// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

// max(floor(N / (1 + N d / z_far)), least); depths behind the far plane, and none, count as on it. A far
// plane beyond 2^126 is at infinity.
inline int gloam_count_by_distance(double depth, double z_far, int base, int least) {
    const double most = std::clamp(base, 0, 4096);
    const bool before = depth >= 0.0 && z_far >= float_min && depth < z_far;
    const double share = before ? (z_far <= 0x1p126 ? depth / z_far : 0.0) : 1.0;
    return std::max(int(most / (1.0 + most * share)), least);
}

}  // namespace gloam::reference
