// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline bool gloam_tap_rejected(double depth, double tap_depth, double threshold) {
    return !gloam_is_background(depth) && !gloam_is_background(tap_depth) && depth - tap_depth > threshold;
}

}  // namespace gloam::reference
