// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_background_depth() {
    return infinity;
}

inline bool gloam_is_background(double depth) {
    return !(depth >= float_min && depth <= float_max);
}

}  // namespace gloam::reference
