// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <complex>

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_occlusion_bowl(double a, double b) {
    return gloam_unit_interval(1.0 - (1.0 / sqrt(std::complex(1.0, a) * std::complex(1.0, b))).real());
}

inline double gloam_occlusion_saddle(double a, double b) {
    const std::complex<double> x(1.0, a);
    const std::complex<double> y(1.0, b);
    const double t = sqrt(-a / b);
    return gloam_unit_interval(2.0 / pi * (atan(t) - (atan(t * sqrt(y / x)) / sqrt(x * y)).real()));
}

inline double gloam_occlusion_curvature(double k_1, double k_2, double radius) {
    if (!(radius > 0.0) || std::isnan(k_1) || std::isnan(k_2)) return 0.0;
    const double a = radius / 2.0 * max(k_1, k_2);
    const double b = radius / 2.0 * min(k_1, k_2);
    if (!(a > 0.0) || std::isnan(b)) return 0.0;
    const auto occlusion = b >= -1e-4 ? gloam_occlusion_bowl : gloam_occlusion_saddle;
    return occlusion(std::clamp(a, -4096.0, 4096.0), std::clamp(b, -4096.0, 4096.0));
}

}  // namespace gloam::reference
