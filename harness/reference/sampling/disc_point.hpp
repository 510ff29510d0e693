// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"

namespace gloam::reference {

inline dvec3 gloam_disc_point(unsigned index) {
    return {gloam_disc_sample(gloam_halton_2d(index)), 0.0};
}

}  // namespace gloam::reference
