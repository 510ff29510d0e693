// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
T gloam_sample_cosine(vec3<T> offset, vec3<T> normal) {
    const T cosine = dot(gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0))), normal);
    return cosine > T(0) ? (cosine < T(1) ? cosine : T(1)) : T(0);
}

}  // namespace gloam::reference
