// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec2 gloam_texel_position(double u, int extent) {
    if (!(u >= 0.0 && u <= 1.0) || extent < 1) return dvec2(0.0);
    const double position = u * double(extent) - 0.5;
    const double first = floor(position);
    const double fraction = position - first;
    if (fraction < 0.00390625) return dvec2(first, 0.0);
    if (fraction > 0.99609375) return dvec2(first + 1.0, 0.0);
    return dvec2(first, fraction);
}

}  // namespace gloam::reference
