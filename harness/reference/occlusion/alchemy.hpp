// SPDX-License-Identifier: MIT
#pragma once

#include "reference/shading/remap.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_alchemy(vec3<T> offset, vec3<T> normal, T bias, T epsilon) {
    const T above = dot(offset, normal) - bias;
    const T denominator = dot(offset, offset) + epsilon;
    if (!(above > T(0) && epsilon >= T(0) && denominator >= float_min<T>() && denominator <= T(0x1p126)))
        return T(0);
    const T contribution = above / denominator;
    return contribution <= float_max<T>() ? contribution : T(0);
}

template <class T>
T gloam_visibility_alchemy(vec2<T> accumulated, T sigma, T k) {
    if (!(accumulated.y >= T(1) && accumulated.x > T(0))) return T(1);
    return gloam_remap(T(1) - T(2) * sigma * (accumulated.x / accumulated.y), T(0), T(1), k);
}

}  // namespace gloam::reference
