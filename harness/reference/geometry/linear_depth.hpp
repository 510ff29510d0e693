// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

// 2^126: beyond it Vulkan leaves a quotient open.
template <class T>
T gloam_depth_quotient(T numerator, T denominator) {
    const bool divides = abs(denominator) >= float_min<T>() && abs(denominator) <= T(0x1p126);
    if (!divides) return infinity<T>();
    const T depth = numerator / denominator;
    if (gloam_is_background(depth)) return infinity<T>();
    return depth;
}

template <class T>
T gloam_linear_depth_perspective_vk(T b, T p22, T p32) {
    return gloam_depth_quotient(p32, b + p22);
}

template <class T>
T gloam_linear_depth_perspective_gl(T b, T p22, T p32) {
    const T denominator = p22 < T(0) ? (T(2) * b - T(1)) + p22 : T(2) * b + (p22 - T(1));
    return gloam_depth_quotient(p32, denominator);
}

template <class T>
T gloam_linear_depth_orthographic_vk(T b, T p22, T p32) {
    return gloam_depth_quotient(p32 - b, p22);
}

template <class T>
T gloam_linear_depth_orthographic_gl(T b, T p22, T p32) {
    const T numerator = p32 < T(0) ? (p32 + T(1)) - T(2) * b : (p32 - T(1)) + T(2) * (T(1) - b);
    return gloam_depth_quotient(numerator, p22);
}

}  // namespace gloam::reference
