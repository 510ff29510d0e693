// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

// alpha (cos, sin)(2 pi alpha turns), alpha = (index + 1/2) / count; whole turns are taken off before 2 pi
// is.
inline dvec2 gloam_spiral_point(int index, int count, int turns) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return dvec2(0.0);
    const double twice = 2.0 * index + 1.0;
    const double part = std::remainder(twice * turns, 2.0 * count);
    return (twice * on_circle(pi * part / count)) / (2.0 * count);
}

inline dvec2 gloam_spiral_tap(int index, int count, int turns, double phase) {
    return gloam_rotate_disc(gloam_spiral_point(index, count, turns), phase);
}

}  // namespace gloam::reference
