// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec3 gloam_camera_centered_previous(dvec3 position, dvec3 eye_delta) {
    const dvec3 previous = position + eye_delta;
    return is_finite(previous) ? previous : dvec3(0.0);
}

}  // namespace gloam::reference
