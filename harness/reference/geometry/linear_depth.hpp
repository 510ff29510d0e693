// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_depth_quotient(double numerator, double denominator) {
    const bool divides = abs(denominator) >= float_min && abs(denominator) <= 0x1p126;
    return divides && !gloam_is_background(numerator / denominator) ? numerator / denominator : infinity;
}

inline double gloam_linear_depth_perspective_vk(double b, double p22, double p32) {
    return gloam_depth_quotient(p32, b + p22);
}

inline double gloam_linear_depth_perspective_gl(double b, double p22, double p32) {
    return gloam_depth_quotient(p32, 2.0 * b + (p22 - 1.0));
}

inline double gloam_linear_depth_orthographic_vk(double b, double p22, double p32) {
    return gloam_depth_quotient(p32 - b, p22);
}

inline double gloam_linear_depth_orthographic_gl(double b, double p22, double p32) {
    return gloam_depth_quotient(p32 + 1.0 - 2.0 * b, p22);
}

}  // namespace gloam::reference
