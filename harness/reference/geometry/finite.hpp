// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// Finite as a float: a number that only a wider type can hold counts as infinite.
inline bool gloam_is_finite(double x) {
    return abs(x) <= float_max;
}

inline bool gloam_is_finite2(dvec2 v) {
    return gloam_is_finite(v.x) && gloam_is_finite(v.y);
}

inline bool gloam_is_finite3(dvec3 v) {
    return gloam_is_finite(v.x) && gloam_is_finite(v.y) && gloam_is_finite(v.z);
}

inline bool gloam_is_finite4(dvec4 v) {
    return gloam_is_finite(v.x) && gloam_is_finite(v.y) && gloam_is_finite(v.z) && gloam_is_finite(v.w);
}

}  // namespace gloam::reference
