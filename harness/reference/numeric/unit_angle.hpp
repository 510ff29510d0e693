// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_unit_angle(dvec2 direction) {
    return std::atan2(direction.y, direction.x);
}

}  // namespace gloam::reference
