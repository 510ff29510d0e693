// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_is_finite(double x) {
    return is_finite(x);
}

inline bool gloam_is_finite2(dvec2 v) {
    return is_finite(v);
}

inline bool gloam_is_finite3(dvec3 v) {
    return is_finite(v);
}

inline bool gloam_is_finite4(dvec4 v) {
    return is_finite(v);
}

}  // namespace gloam::reference
