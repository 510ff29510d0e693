// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
int gloam_sample_count(T convergence, T c_spatial, int k_initial, int k_converged) {
    return max(convergence >= c_spatial ? k_converged : k_initial, 0);
}

}  // namespace gloam::reference
