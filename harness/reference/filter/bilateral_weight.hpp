// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/gaussian.hpp"

namespace gloam::reference {

inline double gloam_bilateral_weight(dvec2 offset, double depth_difference, double sigma_d, double sigma_r) {
    const double weight =
        gloam_gaussian(dot(offset, offset), sigma_d) * gloam_gaussian(pow(depth_difference, 2), sigma_r);
    return weight >= 1e-30 ? weight : 0.0;
}

}  // namespace gloam::reference
