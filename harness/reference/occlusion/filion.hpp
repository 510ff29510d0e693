// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/numeric/length_ratio.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_filion(T sample_depth, T buffer_depth, T radius) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return T(0);
    const T in_front = sample_depth - buffer_depth;
    if (!(in_front >= float_min<T>() && radius >= float_min<T>())) return T(0);
    return in_front <= radius ? T(1) : gloam_length_ratio(radius, in_front);
}

}  // namespace gloam::reference
