// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_remap(T ao, T a, T b, T c) {
    const T base = b * (ao + a);
    if (!(base > T(0))) return base <= T(0) && c > T(0) ? T(0) : T(1);
    const bool open = c > T(0) ? base >= T(1) : (c < T(0) ? base <= T(1) : true);
    if (open) return T(1);
    return c == T(1) ? base : clamp(pow(base, c), T(0), T(1));
}

}  // namespace gloam::reference
