// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_sao_blur_weight(int tap, T key_difference, T slope) {
    if (tap == 0) return T(0.153170);
    if (tap > 4 || tap < -4) return T(0);
    const int r = std::abs(tap);
    const T g = r == 1 ? T(0.144893) : (r == 2 ? T(0.122649) : (r == 3 ? T(0.092902) : T(0.062970)));
    const T difference = abs(key_difference);
    const T fall = difference == T(0) || slope <= T(0) ? T(0) : difference * slope;
    return fall < T(1) ? (T(0.3) + g) * (T(1) - fall) : T(0);
}

}  // namespace gloam::reference
