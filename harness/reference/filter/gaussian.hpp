// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_gaussian_scale(double sigma) {
    if (std::isnan(sigma)) return infinity;
    return sigma <= 0x1p100 ? sqrt(std::numbers::log2e / 2.0) / max(sigma, float_min) : 0.0;
}

inline double gloam_gaussian_scaled(double squared_distance, double scale) {
    const double x = abs(squared_distance) * scale * scale;
    return x <= 99.5 ? exp2(-x) : 0.0;
}

inline double gloam_gaussian(double squared_distance, double sigma) {
    if (!is_finite(squared_distance) || std::isnan(sigma)) return 0.0;
    const double weight = exp(-abs(squared_distance) / (2.0 * pow(max(sigma, float_min), 2)));
    return weight >= 1e-30 ? weight : 0.0;
}

inline double gloam_filter_sigma(double depth, double tan_half_fovy, double height, double sigma_pixels) {
    const bool known = tan_half_fovy > 0.0 && height >= float_min && sigma_pixels > 0.0;
    if (gloam_is_background(depth) || !known) return 0.0;
    const double sigma = sigma_pixels * 2.0 * depth * tan_half_fovy / height;
    return std::isnan(sigma) ? 0.0 : min(sigma, float_max);
}

}  // namespace gloam::reference
