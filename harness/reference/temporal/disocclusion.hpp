// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
bool gloam_depth_consistent(T stored_depth, T expected_depth, T epsilon) {
    if (gloam_is_background(stored_depth) || gloam_is_background(expected_depth)) return false;
    return abs(stored_depth - expected_depth) < epsilon * stored_depth;
}

template <class T>
bool gloam_both_background(T stored_depth, T expected_depth) {
    return gloam_is_background(stored_depth) && gloam_is_background(expected_depth);
}

}  // namespace gloam::reference
