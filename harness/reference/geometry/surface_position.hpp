// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline bool gloam_is_surface_position(dvec3 position) {
    return gloam_is_finite3(position) && (position.x != 0.0 || position.y != 0.0 || position.z != 0.0);
}

}  // namespace gloam::reference
