// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// H + (H^2 - K)^(1/2) and H - (H^2 - K)^(1/2) of the mean and the Gaussian curvature, from the first and
// second fundamental forms (e f; f g) and (l m; m n).
inline dvec2 gloam_principal_curvatures(dvec3 position_x, dvec3 position_y, dvec3 normal_x, dvec3 normal_y) {
    const double e = dot(position_x, position_x);
    const double f = dot(position_x, position_y);
    const double g = dot(position_y, position_y);
    const double area = e * g - f * f;
    if (!(e >= 1e-18 && g >= 1e-18 && e <= 1e18 && g <= 1e18 && area > 1e-8 * e * g)) return dvec2(0.0);
    const double l = -dot(position_x, normal_x);
    const double m = -(dot(position_x, normal_y) + dot(position_y, normal_x)) / 2.0;
    const double n = -dot(position_y, normal_y);
    const double mean = (e * n - 2.0 * f * m + g * l) / (2.0 * area);
    const double gaussian = (l * n - m * m) / area;
    const double spread = sqrt(max(mean * mean - gaussian, 0.0));
    const dvec2 curvatures(mean + spread, mean - spread);
    return is_finite(curvatures) ? curvatures : dvec2(0.0);
}

}  // namespace gloam::reference
