// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
bool gloam_is_surface_position(vec3<T> position) {
    return gloam_is_finite3(position) && (position.x != T(0) || position.y != T(0) || position.z != T(0));
}

}  // namespace gloam::reference
