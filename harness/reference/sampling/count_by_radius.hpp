// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

// The nearest whole number to most r / r_ref.
inline int gloam_count_by_radius(double radius, double reference_radius, int least, int most) {
    if (!(reference_radius >= float_min) || radius >= reference_radius) return most;
    if (!(radius > 0.0)) return least;
    return std::clamp(int(most * (radius / reference_radius) + 0.5), least, most);
}

}  // namespace gloam::reference
