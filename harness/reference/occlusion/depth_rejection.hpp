// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/gather_kernel.hpp"

namespace gloam::reference {

inline bool gloam_tap_rejected(double depth, double tap_depth, double threshold) {
    return gloam_tap_sees(depth) && gloam_tap_sees(tap_depth) && depth - tap_depth > threshold;
}

}  // namespace gloam::reference
