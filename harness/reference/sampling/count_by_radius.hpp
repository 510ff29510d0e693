// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline int gloam_count_by_radius(double radius, double reference_radius, int least, int most) {
    if (!(reference_radius >= float_min)) return most;
    if (!(radius > 0.0)) return least;
    if (radius >= reference_radius) return most;
    const double share =
        reference_radius > 0x1p126 ? (radius * 0.25) / (reference_radius * 0.25) : radius / reference_radius;
    return clamp(int(floor(double(most) * share + 0.5)), least, most);
}

}  // namespace gloam::reference
