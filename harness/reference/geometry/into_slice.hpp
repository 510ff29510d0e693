// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_into_slice(vec3<T> offset, vec3<T> axis, vec3<T> normal) {
    const T turned = dot(axis, normal);
    const T steep = T(1) - turned * turned;
    vec3<T> across = axis;
    if (steep > T(1e-3F)) across = (axis - turned * normal) / steep;
    const vec3<T> moved = offset - dot(offset, axis) * across;
    return gloam_is_finite3(moved) ? moved : vec3<T>(T(0), T(0), T(0));
}

}  // namespace gloam::reference
