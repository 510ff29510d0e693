// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline dvec3 gloam_camera_centered_previous(dvec3 position, dvec3 eye_delta) {
    const dvec3 previous = position + eye_delta;
    if (gloam_is_finite3(previous)) return previous;
    return dvec3(0.0);
}

}  // namespace gloam::reference
