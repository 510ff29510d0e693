// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline double gloam_gaussian_scale(double sigma) {
    if (!(abs(sigma) >= 0.0)) return infinity;
    return sigma <= 0x1p100 ? 0.8493218002880191 / max(sigma, float_min) : 0.0;
}

inline double gloam_gaussian_scaled(double squared_distance, double scale) {
    const double x = squared_distance * scale * scale;
    const double weight = min(exp2(-max(x, 0.0)), 1.0);
    return x <= 99.5 ? weight : 0.0;
}

inline double gloam_gaussian(double squared_distance, double sigma) {
    return gloam_gaussian_scaled(squared_distance, gloam_gaussian_scale(sigma));
}

inline double gloam_filter_sigma(double depth, double tan_half_fovy, double height, double sigma_pixels) {
    const bool known = tan_half_fovy > 0.0 && height >= float_min && sigma_pixels > 0.0;
    if (gloam_is_background(depth) || !known) return 0.0;
    const double sigma = 2.0 * tan_half_fovy * depth * (sigma_pixels / height);
    return sigma <= float_max ? sigma : (sigma > 0.0 ? float_max : 0.0);
}

}  // namespace gloam::reference
