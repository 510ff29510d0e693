// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_convergence(T weight, T weight_max) {
    if (!(weight_max >= float_min<T>())) return T(1);
    if (!(weight > T(0))) return T(0);
    return weight < weight_max ? min(weight / weight_max, T(1)) : T(1);
}

}  // namespace gloam::reference
