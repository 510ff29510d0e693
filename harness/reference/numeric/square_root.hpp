// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_sqrt(T x) {
    if (!(x >= float_min<T>())) return T(0);
    if constexpr (exact_number<T>) return sqrt(x);
    return x <= float_max<T>() ? x * inversesqrt(x) : x;
}

}  // namespace gloam::reference
