// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline dvec2 gloam_paired_sample(dvec2 s, int index) {
    if (!is_finite(s)) return dvec2(0.0);
    return index % 2 == 0 ? s : -s;
}

}  // namespace gloam::reference
