// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/halton.hpp"

namespace gloam::reference {

inline dvec3 gloam_halton_point(unsigned index) {
    return gloam_halton_3d(index);
}

}  // namespace gloam::reference
