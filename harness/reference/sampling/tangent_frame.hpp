// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// Rodrigues' rotation of z onto n, 1 + K + K^2 / (1 + n.z) with K = (z x n) x; below the horizon of z that
// onto -n, with y negated to stay right-handed.
inline dmat3 gloam_tangent_frame(dvec3 n) {
    const double side = n.z < 0.0 ? -1.0 : 1.0;
    const dvec3 up = side * n;
    const dmat3 k(0.0, 0.0, -up.x, 0.0, 0.0, -up.y, up.x, up.y, 0.0);
    const dmat3 rotation = dmat3(1.0) + k + k * k / (1.0 + up.z);
    return {rotation[0], side * rotation[1], n};
}

}  // namespace gloam::reference
