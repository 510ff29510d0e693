// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_depth_darkening(T depth, T blurred_depth, T strength) {
    if (gloam_is_background(depth) || gloam_is_background(blurred_depth) || !(strength > T(0))) return T(0);
    const T difference = blurred_depth - depth;
    return difference < T(0) ? max(strength * difference, -float_max<T>()) : T(0);
}

}  // namespace gloam::reference
