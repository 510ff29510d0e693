// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
bool gloam_rotation_enabled(T convergence, T c_rot) {
    return !(convergence >= c_rot);
}

}  // namespace gloam::reference
