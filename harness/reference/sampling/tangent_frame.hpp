// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

// Rodrigues' rotation of z onto n; below the horizon of z onto -n, with y then negated to stay right-handed.
template <class T>
mat3<T> gloam_tangent_frame(vec3<T> normal) {
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(1)));
    const vec3<T> up = n.z < T(0) ? -n : n;
    const T k = T(1) / (T(1) + up.z);
    const vec3<T> x_turned(T(1) - up.x * up.x * k, -up.x * up.y * k, -up.x);
    const vec3<T> y_turned(-up.x * up.y * k, T(1) - up.y * up.y * k, -up.y);
    if (n.z < T(0)) return mat3<T>(x_turned, -y_turned, n);
    return mat3<T>(x_turned, y_turned, n);
}

}  // namespace gloam::reference
