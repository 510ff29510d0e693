// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline bool gloam_depth_consistent(double stored_depth, double expected_depth, double epsilon) {
    if (gloam_is_background(stored_depth) || gloam_is_background(expected_depth)) return false;
    return abs(1.0 - expected_depth / stored_depth) < epsilon;
}

inline bool gloam_both_background(double stored_depth, double expected_depth) {
    return gloam_is_background(stored_depth) && gloam_is_background(expected_depth);
}

}  // namespace gloam::reference
