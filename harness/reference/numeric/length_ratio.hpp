// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_length_ratio(T smaller, T larger) {
    if (larger > float_max<T>()) return smaller > float_max<T>() ? T(1) : T(0);
    const T scale = larger > T(0x1p126) ? T(0.25) : T(1);
    return min(smaller * scale / (max(larger, float_min<T>()) * scale), T(1));
}

}  // namespace gloam::reference
