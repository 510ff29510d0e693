// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

inline dvec2 gloam_halton_disc(unsigned index, dvec2 turn) {
    return gloam_turn_disc(gloam_disc_sample(gloam_halton_2d(index)), turn);
}

}  // namespace gloam::reference
