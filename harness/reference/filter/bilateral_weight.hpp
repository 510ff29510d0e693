// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/gaussian.hpp"

namespace gloam::reference {

template <class T>
T gloam_bilateral_weight(vec2<T> offset, T depth_difference, T sigma_d, T sigma_r) {
    const T weight = gloam_gaussian(dot(offset, offset), sigma_d) *
                     gloam_gaussian(depth_difference * depth_difference, sigma_r);
    return weight >= T(1e-30) ? weight : T(0);
}

}  // namespace gloam::reference
