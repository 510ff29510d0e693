// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_sao_blur_weight(int tap, double key_difference, double slope) {
    if (tap == 0) return 0.153170;
    if (tap > 4 || tap < -4) return 0.0;
    const int r = std::abs(tap);
    const double g = r == 1 ? 0.144893 : (r == 2 ? 0.122649 : (r == 3 ? 0.092902 : 0.062970));
    const double difference = abs(key_difference);
    const double fall = difference == 0.0 || slope <= 0.0 ? 0.0 : difference * slope;
    return fall < 1.0 ? (0.3 + g) * (1.0 - fall) : 0.0;
}

}  // namespace gloam::reference
