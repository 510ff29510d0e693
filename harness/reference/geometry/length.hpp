// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

template <class T>
T gloam_length(vec3<T> v) {
    const T along = dot(v, gloam_safe_normalize(v, vec3<T>(T(0), T(0), T(0))));
    return along > T(0) ? along : T(0);
}

}  // namespace gloam::reference
