// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"

namespace gloam::reference {

inline dvec3 gloam_hemisphere_uniform_point(unsigned index) {
    return gloam_hemisphere_uniform(gloam_halton_3d(index));
}

}  // namespace gloam::reference
