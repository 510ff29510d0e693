// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// smaller / larger for 0 <= smaller <= larger; infinite lengths are equal.
inline double gloam_length_ratio(double smaller, double larger) {
    if (std::isinf(smaller)) return 1.0;
    return min(smaller / max(larger, float_min), 1.0);
}

}  // namespace gloam::reference
