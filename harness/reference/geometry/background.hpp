// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T = double>
T gloam_background_depth() {
    return infinity<T>();
}

template <class T>
bool gloam_is_background(T depth) {
    return !(depth >= float_min<T>() && depth <= float_max<T>());
}

}  // namespace gloam::reference
