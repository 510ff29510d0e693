// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
mat3<T> gloam_tangent_frame(vec3<T> normal) {
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(1)));
    const T side = n.z > T(0) || !(normal.z < T(0)) ? T(1) : T(-1);
    const T a = T(-1) / (side + n.z);
    const T b = n.x * n.y * a;
    const vec3<T> tangent(T(1) + side * n.x * n.x * a, side * b, -side * n.x);
    const vec3<T> bitangent(b, side + n.y * n.y * a, -n.y);
    return mat3<T>(tangent, bitangent, n);
}

}  // namespace gloam::reference
