// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/radical_inverse.hpp"

namespace gloam::reference {

inline dvec2 gloam_halton_2d(unsigned index) {
    return dvec2(gloam_radical_inverse_base2(index), gloam_radical_inverse(index, 3U));
}

inline dvec3 gloam_halton_3d(unsigned index) {
    const dvec2 first = gloam_halton_2d(index);
    return dvec3(first.x, first.y, gloam_radical_inverse(index, 5U));
}

}  // namespace gloam::reference
