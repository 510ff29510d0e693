// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// Within 1/256 of a texel's centre: that texel alone.
inline dvec2 gloam_texel_position(double u, int extent) {
    if (!(u >= 0.0 && u <= 1.0) || extent < 1) return dvec2(0.0);
    const double position = u * extent - 0.5;
    const double nearest = std::round(position);
    if (abs(position - nearest) < 1.0 / 256.0) return {nearest, 0.0};
    return {floor(position), fract(position)};
}

}  // namespace gloam::reference
