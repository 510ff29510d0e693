// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_into_slice(vec3<T> offset, vec3<T> axis, vec3<T> normal) {
    const T turned = dot(axis, normal);
    const T steep = T(1) - turned * turned;
    vec3<T> across = axis;
    if (steep > T(1e-3F)) across = (axis - turned * normal) / steep;
    return offset - dot(offset, axis) * across;
}

}  // namespace gloam::reference
