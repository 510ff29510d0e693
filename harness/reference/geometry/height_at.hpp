// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline double gloam_height_at(dvec3 offset, dvec3 aim, dvec3 view, dvec3 normal) {
    const double facing = dot(view, normal);
    const double height = dot(offset - aim, normal) / (facing <= double(1e-4F) ? double(1e-4F) : facing);
    return gloam_is_finite(height) ? height : 0.0;
}

}  // namespace gloam::reference
