// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_rotation_enabled(double convergence, double c_rot) {
    return !(convergence >= c_rot);  // NaN: an unknown convergence is none
}

}  // namespace gloam::reference
