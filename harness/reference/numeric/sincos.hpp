// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// (cos, sin) of an angle in radians.
inline dvec2 on_circle(double angle) {
    return {cos(angle), sin(angle)};
}

// The direction of the rest, turned by 90 degrees as many times.
inline dvec2 gloam_sincos_octant(double rest, int quarters) {
    dvec2 v = on_circle(rest);
    for (int i = 0; i < (quarters & 3); ++i) v = dvec2(-v.y, v.x);
    return v;
}

inline dvec2 gloam_sincos_turns(double turns) {
    if (!std::isfinite(turns)) return {1.0, 0.0};
    return on_circle(2.0 * pi * std::remainder(turns, 1.0));
}

inline double gloam_turns(double angle) {
    return abs(angle) <= 65536.0 ? angle / (2.0 * pi) : 0.0;
}

inline dvec2 gloam_sincos(double angle) {
    return on_circle(abs(angle) <= 65536.0 ? angle : 0.0);
}

}  // namespace gloam::reference
