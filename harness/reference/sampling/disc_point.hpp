// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_disc_point(unsigned index) {
    return vec3<T>(gloam_disc_sample(gloam_halton_2d<T>(index)), T(0));
}

}  // namespace gloam::reference
