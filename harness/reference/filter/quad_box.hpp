// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/visibility.hpp"

namespace gloam::reference {

template <class T>
T gloam_quad_box(T visibility, T difference, T depth_difference, int coordinate, T edge) {
    const bool smooth_here = abs(depth_difference) < edge && abs(difference) <= float_max<T>();
    const T side = (coordinate & 1) == 1 ? T(0.5) : T(-0.5);
    return gloam_visibility_clamp(smooth_here ? visibility - difference * side : visibility);
}

}  // namespace gloam::reference
