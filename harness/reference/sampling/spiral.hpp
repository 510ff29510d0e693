// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/circle.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T = double>
vec2<T> gloam_spiral_point(int index, int count, int turns) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return vec2<T>(T(0), T(0));
    const unsigned period = 2U * static_cast<unsigned>(count);
    const unsigned odd = 2U * static_cast<unsigned>(index) + 1U;
    const unsigned whole = turns < 0 ? 0U - static_cast<unsigned>(turns) : static_cast<unsigned>(turns);
    const unsigned angle = ((whole % period) * odd) % period;
    const vec2<T> tap = gloam_circle_point(T(angle) / T(period));
    const T radius = T(odd) / T(period);
    return radius * vec2<T>(tap.x, turns < 0 ? -tap.y : tap.y);
}

template <class T>
vec2<T> gloam_spiral_tap(int index, int count, int turns, T phase) {
    return gloam_rotate_disc(gloam_spiral_point<T>(index, count, turns), phase);
}

}  // namespace gloam::reference
