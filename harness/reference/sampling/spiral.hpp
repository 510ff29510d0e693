// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_spiral_tap(int index, int count, int turns, T phase) {
    if (count < 1 || count > 32768 || index < 0 || index >= count) return vec2<T>(T(0), T(0));
    const T alpha = (T(index) + T(0.5)) / T(count);
    // Whole turns are taken off in integers: alpha * turns has lost digits of the fraction when turns is
    // large.
    const long long period = 2LL * count;
    const auto part = static_cast<double>(static_cast<long long>(turns) * (2LL * index + 1LL) % period);
    const T theta = T(2) * pi<T>() * T(part) / T(static_cast<double>(period)) + gloam_wrap_angle(phase);
    return vec2<T>(alpha * cos(theta), alpha * sin(theta));
}

}  // namespace gloam::reference
