// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_remap(T ao, T a, T b, T c) {
    const T base = b * (ao + a);
    const bool base_known = base <= T(0) || base > T(0);
    const bool contrast_known = c <= T(0) || c > T(0);
    if (!base_known || !contrast_known || c == T(0)) return T(1);
    if (base <= T(0)) return c > T(0) ? T(0) : T(1);
    if (base == T(1)) return T(1);
    const T power = pow(base, c);
    if (power >= T(1)) return T(1);
    return power > T(0) ? power : T(0);
}

}  // namespace gloam::reference
