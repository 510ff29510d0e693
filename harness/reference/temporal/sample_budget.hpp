// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

inline int gloam_sample_count(double convergence, double c_spatial, int k_initial, int k_converged) {
    return std::max(convergence >= c_spatial ? k_converged : k_initial, 0);
}

}  // namespace gloam::reference
