// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

// 2^126: beyond it Vulkan leaves a quotient open.
inline double gloam_depth_quotient(double numerator, double denominator) {
    const bool divides = abs(denominator) >= float_min && abs(denominator) <= 0x1p126;
    if (!divides) return infinity;
    const double depth = numerator / denominator;
    if (gloam_is_background(depth)) return infinity;
    return depth;
}

inline double gloam_linear_depth_perspective_vk(double b, double p22, double p32) {
    return gloam_depth_quotient(p32, b + p22);
}

inline double gloam_linear_depth_perspective_gl(double b, double p22, double p32) {
    const double denominator = p22 < 0.0 ? (2.0 * b - 1.0) + p22 : 2.0 * b + (p22 - 1.0);
    return gloam_depth_quotient(p32, denominator);
}

inline double gloam_linear_depth_orthographic_vk(double b, double p22, double p32) {
    return gloam_depth_quotient(p32 - b, p22);
}

inline double gloam_linear_depth_orthographic_gl(double b, double p22, double p32) {
    const double numerator = p32 < 0.0 ? (p32 + 1.0) - 2.0 * b : (p32 - 1.0) + 2.0 * (1.0 - b);
    return gloam_depth_quotient(numerator, p22);
}

}  // namespace gloam::reference
