// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

inline dvec2 gloam_principal_curvatures(dvec3 position_x, dvec3 position_y, dvec3 normal_x, dvec3 normal_y) {
    const dvec2 none(0.0, 0.0);
    const double e = dot(position_x, position_x);
    const double g = dot(position_y, position_y);
    const dvec3 span = cross(position_x, position_y);
    const double area2 = dot(span, span);
    const bool spanned = e >= 1e-18 && g >= 1e-18 && e <= 1e18 && g <= 1e18 && area2 > 1e-8 * e * g;
    if (!spanned) return none;
    const double shear = dot(position_x, position_y) / e;
    const double l = -dot(position_x, normal_x);
    const double m = -0.5 * (dot(position_x, normal_y) + dot(position_y, normal_x)) - shear * l;
    const double n = -dot(position_y, normal_y) - shear * (2.0 * m + shear * l);
    const double a = l / e;
    const double b = n * (e / area2);
    const double c = m / gloam_sqrt(area2);
    const double half_difference = 0.5 * (a - b);
    const double spread = gloam_sqrt(half_difference * half_difference + c * c);
    const dvec2 curvatures(0.5 * (a + b) + spread, 0.5 * (a + b) - spread);
    const bool finite = abs(curvatures.x) <= float_max && abs(curvatures.y) <= float_max;
    return finite ? curvatures : none;
}

}  // namespace gloam::reference
