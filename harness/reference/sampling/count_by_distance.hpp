// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
int gloam_count_by_distance(T depth, T z_far, int base, int least) {
    const T start = T(std::clamp(base, 0, 4096));
    const bool placed = depth >= T(0) && z_far >= float_min<T>() && depth < z_far;
    const T distance_part = placed ? (z_far <= T(0x1p126) ? depth / z_far : T(0)) : T(1);
    return std::max(to_int(start / (T(1) + start * distance_part)), least);
}

}  // namespace gloam::reference
