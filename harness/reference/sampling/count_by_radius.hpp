// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
int gloam_count_by_radius(T radius, T reference_radius, int least, int most) {
    if (!(reference_radius >= float_min<T>())) return most;
    if (!(radius > T(0))) return least;
    if (radius >= reference_radius) return most;
    const T share = reference_radius > T(0x1p126) ? (radius * T(0.25)) / (reference_radius * T(0.25))
                                                  : radius / reference_radius;
    return clamp(to_int(floor(T(most) * share + T(0.5))), least, most);
}

}  // namespace gloam::reference
