// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline dvec3 gloam_into_slice(dvec3 offset, dvec3 axis, dvec3 normal) {
    const double turned = dot(axis, normal);
    const double steep = 1.0 - turned * turned;
    dvec3 across = axis;
    if (steep > double(1e-3F)) across = (axis - turned * normal) / steep;
    const dvec3 moved = offset - dot(offset, axis) * across;
    return gloam_is_finite3(moved) ? moved : dvec3(0.0);
}

}  // namespace gloam::reference
