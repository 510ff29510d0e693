// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_paired_sample(vec2<T> s, int index) {
    if (!is_finite(s)) return vec2<T>(T(0), T(0));
    if ((index & 1) == 0) return s;
    return -s;
}

}  // namespace gloam::reference
