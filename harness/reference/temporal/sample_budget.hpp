// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
int gloam_sample_count(T convergence, T c_spatial, int k_initial, int k_converged) {
    int k = k_initial;
    if (convergence >= c_spatial) k = k_converged;
    return k < 0 ? 0 : k;
}

}  // namespace gloam::reference
