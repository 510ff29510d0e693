// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_depth_bias(T bias, T depth, T reference_depth) {
    if (gloam_is_background(depth) ||
        !(bias > T(0) && reference_depth >= float_min<T>() && reference_depth <= T(0x1p126)))
        return T(0);
    const T scaled = bias * (depth / reference_depth);
    return scaled <= float_max<T>() ? scaled : (scaled > T(0) ? float_max<T>() : T(0));
}

}  // namespace gloam::reference
