// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/halton.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_halton_point(unsigned index) {
    return gloam_halton_3d<T>(index);
}

}  // namespace gloam::reference
