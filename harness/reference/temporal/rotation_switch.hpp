// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
bool gloam_rotation_enabled(T convergence, T c_rot) {
    if (convergence >= c_rot) return false;
    return true;
}

}  // namespace gloam::reference
