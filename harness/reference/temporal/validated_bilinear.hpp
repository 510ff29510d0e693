// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec4<T> gloam_bilinear_weights(vec2<T> fraction) {
    const vec2<T> f(gloam_unit_interval(fraction.x), gloam_unit_interval(fraction.y));
    const vec2<T> g = T(1) - f;
    return vec4<T>(g.x * g.y, f.x * g.y, g.x * f.y, f.x * f.y);
}

template <class T>
vec4<T> gloam_validated_weights(vec4<T> bilinear, glm::bvec4 valid) {
    vec4<T> w(T(0), T(0), T(0), T(0));
    for (int i = 0; i < 4; ++i) {
        if (valid[i]) w[i] = gloam_unit_interval(bilinear[i]);
    }
    const T sum = (w.x + w.y) + (w.z + w.w);
    if (!(sum >= float_min<T>())) return vec4<T>(T(0), T(0), T(0), T(0));
    return min(w / sum, vec4<T>(T(1), T(1), T(1), T(1)));
}

}  // namespace gloam::reference
