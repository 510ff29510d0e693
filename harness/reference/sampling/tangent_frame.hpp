// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"

namespace gloam::reference {

inline dmat3 gloam_tangent_frame(dvec3 normal) {
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0, 0.0, 1.0));
    const double side = n.z > 0.0 || !(normal.z < 0.0) ? 1.0 : -1.0;
    const double a = -1.0 / (side + n.z);
    const double b = n.x * n.y * a;
    const dvec3 tangent(1.0 + side * n.x * n.x * a, side * b, -side * n.x);
    const dvec3 bitangent(b, side + n.y * n.y * a, -n.y);
    return dmat3(tangent, bitangent, n);
}

}  // namespace gloam::reference
