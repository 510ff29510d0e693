// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
bool gloam_tap_rejected(T depth, T tap_depth, T threshold) {
    if (gloam_is_background(depth) || gloam_is_background(tap_depth)) return false;
    return depth - tap_depth > threshold;
}

}  // namespace gloam::reference
