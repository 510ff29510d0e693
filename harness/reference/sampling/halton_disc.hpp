// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_halton_disc(unsigned index, T angle) {
    const vec2<T> zeta = gloam_halton_2d<T>(index);
    return gloam_rotate_disc(gloam_disc_sample(zeta), angle);
}

}  // namespace gloam::reference
