// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_texel_position(T u, int extent) {
    if (!(u >= T(0) && u <= T(1)) || extent < 1) return vec2<T>(T(0), T(0));
    const T position = u * T(extent) - T(0.5);
    const T first = floor(position);
    const T fraction = position - first;
    if (fraction < T(0.00390625)) return vec2<T>(first, T(0));
    if (fraction > T(0.99609375)) return vec2<T>(first + T(1), T(0));
    return vec2<T>(first, fraction);
}

}  // namespace gloam::reference
