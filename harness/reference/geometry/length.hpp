// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

namespace gloam::reference {

// Whether a vector is finite and not zero; a subnormal component counts as zero.
inline bool has_direction(dvec3 v) {
    return is_finite(v) && std::max({abs(v.x), abs(v.y), abs(v.z)}) >= float_min;
}

inline double gloam_length(dvec3 v) {
    return has_direction(v) ? length(v) : 0.0;
}

}  // namespace gloam::reference
