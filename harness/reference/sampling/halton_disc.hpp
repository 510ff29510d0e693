// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_halton_disc(unsigned index, vec2<T> turn) {
    const vec2<T> zeta = gloam_halton_2d<T>(index);
    return gloam_turn_disc(gloam_disc_sample(zeta), turn);
}

}  // namespace gloam::reference
