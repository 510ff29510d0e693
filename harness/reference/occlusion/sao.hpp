// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/visibility.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_sao_window(double squared_distance, double radius) {
    const double r2 = pow(radius, 2);
    const bool inside = squared_distance >= 0.0 && squared_distance < r2 && radius > 0.0;
    return inside && r2 >= 0x1p-100 && r2 <= 0x1p126 ? 1.0 - squared_distance / r2 : 0.0;
}

inline double gloam_sao_height(dvec3 offset, dvec3 normal, double bias) {
    const double height = dot(offset, normal) - bias;
    return is_finite(height) ? max(height, 0.0) : 0.0;
}

inline double gloam_sao_quotient(double height, double squared_distance, double epsilon) {
    const double divisor = squared_distance + epsilon;
    return divisor >= float_min && divisor <= 0x1p126 && height > 0.0 ? height / divisor : 0.0;
}

inline double gloam_contribution_sao(dvec3 offset, dvec3 normal, double radius, double bias, double epsilon) {
    const double vv = dot(offset, offset);
    return pow(gloam_sao_window(vv, radius), 3) *
           gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

inline double gloam_contribution_sao_paper(dvec3 offset, dvec3 normal, double radius, double bias,
                                           double epsilon) {
    const double vv = dot(offset, offset);
    if (!(gloam_sao_window(vv, radius) > 0.0)) return 0.0;
    return 0.6 * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

// Printed for a radius of 1, as the two that follow: v / r and bias / r stand for v and bias.
inline double gloam_contribution_sao_medium(dvec3 offset, dvec3 normal, double radius, double bias) {
    if (!(gloam_sao_window(dot(offset, offset), radius) > 0.0)) return 0.0;
    const dvec3 v = offset / radius;
    return 4.0 * (1.0 - dot(v, v)) * gloam_sao_height(v, normal, bias / radius) / radius;
}

inline double gloam_contribution_sao_low(dvec3 offset, dvec3 normal, double radius, double bias) {
    if (!(gloam_sao_window(dot(offset, offset), radius) > 0.0)) return 0.0;
    return 2.0 * gloam_sao_height(offset / radius, normal, bias / radius) / radius;
}

inline double gloam_contribution_deep(dvec3 offset, dvec3 normal, double radius, double bias,
                                      double epsilon) {
    const double vv = dot(offset, offset);
    const double reach = sqrt(epsilon + vv);
    if (!(reach >= sqrt(float_min) && reach <= 0x1p126)) return 0.0;
    return gloam_sao_window(vv, radius) * min(gloam_sao_height(offset, normal, bias) / reach, 1.0);
}

inline double gloam_visibility_sao(dvec2 accumulated, double sigma) {
    if (!(accumulated.y >= 1.0 && accumulated.y <= 0x1p24)) return 1.0;
    return gloam_visibility(5.0 * sigma / accumulated.y * accumulated.x);
}

inline double gloam_visibility_deep(dvec2 accumulated, double power) {
    const double mean = accumulated.x / accumulated.y;
    if (!(accumulated.y >= 1.0 && accumulated.y <= 0x1p24 && mean > 0.0)) return 1.0;
    return gloam_remap(max(0.0, 1.0 - sqrt(3.0 * mean)), 0.0, 1.0, power);
}

}  // namespace gloam::reference
