// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/radical_inverse.hpp"

namespace gloam::reference {

inline dvec3 gloam_halton_3d(unsigned index) {
    return {gloam_radical_inverse(index, 2U), gloam_radical_inverse(index, 3U),
            gloam_radical_inverse(index, 5U)};
}

inline dvec2 gloam_halton_2d(unsigned index) {
    return gloam_halton_3d(index);
}

}  // namespace gloam::reference
