// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec4<T> gloam_bilinear_weights(vec2<T> fraction) {
    const T x = gloam_unit_interval(fraction.x);
    const T y = gloam_unit_interval(fraction.y);
    return vec4<T>((T(1) - x) * (T(1) - y), x * (T(1) - y), (T(1) - x) * y, x * y);
}

template <class T>
vec4<T> gloam_validated_weights(vec4<T> bilinear, glm::bvec4 valid) {
    vec4<T> weights(T(0), T(0), T(0), T(0));
    T sum = T(0);
    for (int i = 0; i < 4; ++i) {
        if (valid[i]) weights[i] = gloam_unit_interval(bilinear[i]);
        sum = sum + weights[i];
    }
    if (!(sum >= float_min<T>())) return vec4<T>(T(0), T(0), T(0), T(0));
    return weights / sum;
}

}  // namespace gloam::reference
