// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

// 2^126: beyond it Vulkan leaves a quotient open.
template <class T>
T gloam_depth_quotient(T numerator, T denominator) {
    const bool divides = abs(denominator) >= float_min<T>() && abs(denominator) <= T(8.5070591730234616e37);
    if (!divides) return infinity<T>();
    const T depth = numerator / denominator;
    if (gloam_is_background(depth)) return infinity<T>();
    return depth;
}

// From b = (p22 z + p32) / -z with z = -d.
template <class T>
T gloam_linear_depth_perspective_vk(T b, T p22, T p32) {
    return gloam_depth_quotient(p32, b + p22);
}

// From 2 b - 1 = (p22 z + p32) / -z with z = -d.
template <class T>
T gloam_linear_depth_perspective_gl(T b, T p22, T p32) {
    return gloam_depth_quotient(p32, T(2) * b + (p22 - T(1)));
}

// From b = p22 z + p32 with z = -d.
template <class T>
T gloam_linear_depth_orthographic_vk(T b, T p22, T p32) {
    return gloam_depth_quotient(p32 - b, p22);
}

// From 2 b - 1 = p22 z + p32 with z = -d.
template <class T>
T gloam_linear_depth_orthographic_gl(T b, T p22, T p32) {
    return gloam_depth_quotient((p32 + T(1)) - T(2) * b, p22);
}

}  // namespace gloam::reference
