// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_crytek(T sample_depth, T buffer_depth) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return T(0);
    return buffer_depth <= sample_depth ? T(1) : T(0);
}

template <class T>
T gloam_contribution_crytek_buffer(T sample_value, T buffer_value) {
    return buffer_value < T(1) && buffer_value <= sample_value ? T(1) : T(0);
}

template <class T>
vec3<T> gloam_crytek_sample(vec2<T> uv, T buffer_value, vec3<T> s, T radius, T depth, T z_far) {
    const vec3<T> center(uv.x, uv.y, buffer_value);
    if (gloam_is_background(depth) || !(z_far >= T(1e-30) && z_far <= T(0x1p126))) return center;
    const T a = radius / clamp(depth, T(1e-30), T(0x1p126));
    return center + s * a * vec3<T>(T(1), T(1), buffer_value * (T(100) / z_far));
}

}  // namespace gloam::reference
