// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/visibility.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_sao_window(double squared_distance, double radius) {
    const double r2 = radius * radius;
    const bool inside =
        squared_distance >= 0.0 && squared_distance < r2 && r2 >= float_min && r2 <= 0x1p126 && radius > 0.0;
    return inside ? min((r2 - squared_distance) / r2, 1.0) : 0.0;
}

inline double gloam_sao_height(dvec3 offset, dvec3 normal, double bias) {
    const double height = dot(offset, normal) - bias;
    return height > 0.0 && height <= float_max ? height : 0.0;
}

inline double gloam_sao_quotient(double height, double squared_distance, double epsilon) {
    const double denominator = squared_distance + epsilon;
    const bool divides = denominator >= float_min && denominator <= 0x1p126;
    return divides && height > 0.0 ? height / denominator : 0.0;
}

inline double gloam_contribution_sao(dvec3 offset, dvec3 normal, double radius, double bias, double epsilon) {
    const double vv = dot(offset, offset);
    const double window = gloam_sao_window(vv, radius);
    if (!(window > 0.0)) return 0.0;
    return window * window * window * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

inline double gloam_contribution_sao_paper(dvec3 offset, dvec3 normal, double radius, double bias,
                                           double epsilon) {
    const double vv = dot(offset, offset);
    const bool inside = gloam_sao_window(vv, radius) > 0.0;
    if (!inside) return 0.0;
    return 0.6 * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

inline double gloam_contribution_sao_medium(dvec3 offset, dvec3 normal, double radius, double bias) {
    const double window = gloam_sao_window(dot(offset, offset), radius);
    if (!(window > 0.0)) return 0.0;
    return 4.0 * window * gloam_sao_height(offset, normal, bias) / (radius * radius);
}

inline double gloam_contribution_sao_low(dvec3 offset, dvec3 normal, double radius, double bias) {
    const bool inside = gloam_sao_window(dot(offset, offset), radius) > 0.0;
    return inside ? 2.0 * gloam_sao_height(offset, normal, bias) / (radius * radius) : 0.0;
}

inline double gloam_contribution_deep(dvec3 offset, dvec3 normal, double radius, double bias,
                                      double epsilon) {
    const double vv = dot(offset, offset);
    const double window = gloam_sao_window(vv, radius);
    const double reach = gloam_sqrt(vv + epsilon);
    const bool divides = window > 0.0 && reach > 0.0 && reach <= 0x1p126;
    return divides ? window * min(gloam_sao_height(offset, normal, bias) / reach, 1.0) : 0.0;
}

inline double gloam_visibility_sao(dvec2 accumulated, double sigma) {
    if (!(accumulated.y >= 1.0 && accumulated.y <= 16777216.0)) return 1.0;
    return gloam_visibility(5.0 * sigma * (accumulated.x / accumulated.y));
}

inline double gloam_visibility_deep(dvec2 accumulated, double power) {
    if (!(accumulated.y >= 1.0 && accumulated.y <= 16777216.0)) return 1.0;
    const double open = gloam_visibility(gloam_sqrt(3.0 * (accumulated.x / accumulated.y)));
    return gloam_remap(open, 0.0, 1.0, power);
}

}  // namespace gloam::reference
