// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_is_surface_position(dvec3 position) {
    return is_finite(position) && position != dvec3(0.0);
}

}  // namespace gloam::reference
