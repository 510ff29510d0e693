// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_unit_interval(double x) {
    return std::isnan(x) ? 0.0 : std::clamp(x, 0.0, 1.0);
}

}  // namespace gloam::reference
