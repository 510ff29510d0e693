// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "reference/math.hpp"

namespace gloam::reference {

// Step, linear, quadratic, cubic.
template <class T>
T gloam_falloff_at(unsigned falloff, T x) {
    if (falloff == 0U) return x <= T(1) ? T(1) : T(0);
    const unsigned power = falloff == 2U || falloff == 3U ? falloff : 1U;
    T taken = T(1);
    for (unsigned i = 0; i < power; ++i) taken = taken * x;
    return T(1) - taken;
}

}  // namespace gloam::reference
