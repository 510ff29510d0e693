// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_unit_interval(T x) {
    if (x >= T(1)) return T(1);
    if (x > T(0)) return x;
    return T(0);
}

}  // namespace gloam::reference
