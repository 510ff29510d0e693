// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_convergence(double weight, double weight_max) {
    if (!(weight_max >= float_min)) return 1.0;
    if (!(weight > 0.0)) return 0.0;
    return weight < weight_max ? weight / weight_max : 1.0;
}

}  // namespace gloam::reference
