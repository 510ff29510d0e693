// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec2 gloam_paired_sample(dvec2 s, int index) {
    if (!std::isfinite(s.x + s.y)) return dvec2(0.0);
    if ((index & 1) == 0) return s;
    return -s;
}

}  // namespace gloam::reference
