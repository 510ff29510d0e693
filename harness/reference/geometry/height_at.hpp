// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_height_at(dvec3 offset, dvec3 aim, dvec3 view, dvec3 normal) {
    const double height = dot(offset - aim, normal) / max(dot(view, normal), 1e-4);
    return is_finite(height) ? height : 0.0;
}

}  // namespace gloam::reference
