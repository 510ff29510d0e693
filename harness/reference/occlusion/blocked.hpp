// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_sample_blocked(T sample_depth, T buffer_depth, T bias, T range) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return T(0);
    const T in_front = sample_depth - buffer_depth;
    return in_front > bias && in_front <= range ? T(1) : T(0);
}

}  // namespace gloam::reference
