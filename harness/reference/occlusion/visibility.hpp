// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_visibility(double occlusion) {
    return occlusion > 0.0 ? (occlusion < 1.0 ? 1.0 - occlusion : 0.0) : 1.0;
}

inline double gloam_visibility_clamp(double visibility) {
    return visibility < 1.0 ? (visibility > 0.0 ? visibility : 0.0) : 1.0;
}

}  // namespace gloam::reference
