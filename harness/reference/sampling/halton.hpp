// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/radical_inverse.hpp"

namespace gloam::reference {

template <class T = double>
vec2<T> gloam_halton_2d(unsigned index) {
    return vec2<T>(gloam_radical_inverse_base2<T>(index), gloam_radical_inverse<T>(index, 3U));
}

template <class T = double>
vec3<T> gloam_halton_3d(unsigned index) {
    const vec2<T> first = gloam_halton_2d<T>(index);
    return vec3<T>(first.x, first.y, gloam_radical_inverse<T>(index, 5U));
}

}  // namespace gloam::reference
