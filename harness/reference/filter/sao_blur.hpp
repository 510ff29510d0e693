// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_sao_blur_weight(int tap, double key_difference, double slope) {
    constexpr double gaussian[] = {0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
    if (tap < -4 || tap > 4) return 0.0;
    if (tap == 0) return gaussian[0];
    const double fall = key_difference == 0.0 || slope <= 0.0 ? 0.0 : slope * abs(key_difference);
    return std::isnan(fall) ? 0.0 : (0.3 + gaussian[std::abs(tap)]) * max(0.0, 1.0 - fall);
}

}  // namespace gloam::reference
