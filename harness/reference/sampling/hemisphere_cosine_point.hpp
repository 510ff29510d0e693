// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_hemisphere_cosine_point(unsigned index) {
    return gloam_hemisphere_cosine(gloam_halton_3d<T>(index));
}

}  // namespace gloam::reference
