// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/circle.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

inline dvec2 gloam_spiral_point(int index, int count, int turns) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return dvec2(0.0);
    const unsigned period = 2U * static_cast<unsigned>(count);
    const unsigned odd = 2U * static_cast<unsigned>(index) + 1U;
    const unsigned whole = turns < 0 ? 0U - static_cast<unsigned>(turns) : static_cast<unsigned>(turns);
    const unsigned angle = ((whole % period) * odd) % period;
    const dvec2 tap = gloam_circle_point(angle / double(period));
    const double radius = double(odd) / double(period);
    return radius * dvec2(tap.x, turns < 0 ? -tap.y : tap.y);
}

inline dvec2 gloam_spiral_tap(int index, int count, int turns, double phase) {
    return gloam_rotate_disc(gloam_spiral_point(index, count, turns), phase);
}

}  // namespace gloam::reference
