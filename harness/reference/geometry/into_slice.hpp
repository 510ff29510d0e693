// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// u of the tangent plane with u . axis = 1; the axis itself where the slice is within 2 degrees of that
// plane.
inline dvec3 along_tangent_plane(dvec3 axis, dvec3 normal) {
    const double cosine = dot(axis, normal);
    const double sine_squared = 1.0 - cosine * cosine;
    return sine_squared > 1e-3 ? (axis - cosine * normal) / sine_squared : axis;
}

inline dvec3 gloam_into_slice(dvec3 offset, dvec3 axis, dvec3 normal) {
    const dvec3 moved = offset - dot(offset, axis) * along_tangent_plane(axis, normal);
    return is_finite(moved) ? moved : dvec3(0.0);
}

}  // namespace gloam::reference
