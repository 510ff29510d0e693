// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
T gloam_sample_cosine(vec3<T> offset, vec3<T> normal) {
    const T cosine = dot(gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0))), normal);
    if (cosine >= T(1)) return T(1);
    if (cosine > T(0)) return cosine;
    return T(0);
}

}  // namespace gloam::reference
