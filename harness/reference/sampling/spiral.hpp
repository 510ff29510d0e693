// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_spiral_tap(int index, int count, int turns, T phase) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return vec2<T>(T(0), T(0));
    const T alpha = (T(index) + T(0.5)) / T(count);
    // Whole turns are taken off in turns, where the fraction keeps its digits, rather than in radians.
    const T theta = T(2) * pi<T>() * fract(alpha * T(turns)) + gloam_wrap_angle(phase);
    return vec2<T>(alpha * cos(theta), alpha * sin(theta));
}

}  // namespace gloam::reference
