// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_clamp_cosine(T x) {
    return abs(x) <= T(1) ? x : (x > T(1) ? T(1) : (x < T(-1) ? T(-1) : T(0)));
}

template <class T>
T gloam_acos_linear(T x) {
    return T(1.570796327) - T(1.570796327) * gloam_clamp_cosine(x);
}

template <class T>
T gloam_acos_quadratic(T x) {
    const T c = gloam_clamp_cosine(x);
    return T(1.570796327) - T(1.570796327) * (c * abs(c));
}

template <class T>
T gloam_acos_cubic(T x) {
    const T c = gloam_clamp_cosine(x);
    return clamp((T(-0.6981317008) * (c * c) - T(0.8726646260)) * c + T(1.570796327), T(0), T(3.141592654));
}

}  // namespace gloam::reference
