// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_layers_occlusion(T occlusion, T layer) {
    return max(gloam_unit_interval(occlusion), gloam_unit_interval(layer));
}

template <class T>
T gloam_layer_blocked(T sample_depth, T front, T back) {
    if (gloam_is_background(sample_depth) || gloam_is_background(front)) return T(0);
    const bool before_back = gloam_is_background(back) || sample_depth <= back;
    return front <= sample_depth && before_back ? T(1) : T(0);
}

}  // namespace gloam::reference
