// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_camera_centered_previous(vec3<T> position, vec3<T> eye_delta) {
    const vec3<T> previous = position + eye_delta;
    if (gloam_is_finite3(previous)) return previous;
    return vec3<T>(T(0), T(0), T(0));
}

}  // namespace gloam::reference
