// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
T gloam_height_at(vec3<T> offset, vec3<T> aim, vec3<T> view, vec3<T> normal) {
    const T facing = dot(view, normal);
    const T height = dot(offset - aim, normal) / (facing <= T(1e-4F) ? T(1e-4F) : facing);
    return gloam_is_finite(height) ? height : T(0);
}

}  // namespace gloam::reference
