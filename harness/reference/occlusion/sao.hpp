// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/visibility.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

template <class T>
T gloam_sao_window(T squared_distance, T radius) {
    const T r2 = radius * radius;
    const bool inside = squared_distance >= T(0) && squared_distance < r2 && r2 >= float_min<T>() &&
                        r2 <= T(0x1p126) && radius > T(0);
    return inside ? min((r2 - squared_distance) / r2, T(1)) : T(0);
}

template <class T>
T gloam_sao_height(vec3<T> offset, vec3<T> normal, T bias) {
    const T height = dot(offset, normal) - bias;
    return height > T(0) && height <= float_max<T>() ? height : T(0);
}

template <class T>
T gloam_sao_quotient(T height, T squared_distance, T epsilon) {
    const T denominator = squared_distance + epsilon;
    const bool divides = denominator >= float_min<T>() && denominator <= T(0x1p126);
    return divides && height > T(0) ? height / denominator : T(0);
}

template <class T>
T gloam_contribution_sao(vec3<T> offset, vec3<T> normal, T radius, T bias, T epsilon) {
    const T vv = dot(offset, offset);
    const T window = gloam_sao_window(vv, radius);
    if (!(window > T(0))) return T(0);
    return window * window * window * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

template <class T>
T gloam_contribution_sao_paper(vec3<T> offset, vec3<T> normal, T radius, T bias, T epsilon) {
    const T vv = dot(offset, offset);
    const bool inside = gloam_sao_window(vv, radius) > T(0);
    if (!inside) return T(0);
    return T(0.6) * gloam_sao_quotient(gloam_sao_height(offset, normal, bias), vv, epsilon);
}

template <class T>
T gloam_contribution_sao_medium(vec3<T> offset, vec3<T> normal, T radius, T bias) {
    const T window = gloam_sao_window(dot(offset, offset), radius);
    if (!(window > T(0))) return T(0);
    return T(4) * window * gloam_sao_height(offset, normal, bias) / (radius * radius);
}

template <class T>
T gloam_contribution_sao_low(vec3<T> offset, vec3<T> normal, T radius, T bias) {
    const bool inside = gloam_sao_window(dot(offset, offset), radius) > T(0);
    return inside ? T(2) * gloam_sao_height(offset, normal, bias) / (radius * radius) : T(0);
}

template <class T>
T gloam_contribution_deep(vec3<T> offset, vec3<T> normal, T radius, T bias, T epsilon) {
    const T vv = dot(offset, offset);
    const T window = gloam_sao_window(vv, radius);
    const T reach = gloam_sqrt(vv + epsilon);
    const bool divides = window > T(0) && reach > T(0) && reach <= T(0x1p126);
    return divides ? window * min(gloam_sao_height(offset, normal, bias) / reach, T(1)) : T(0);
}

template <class T>
T gloam_visibility_sao(vec2<T> accumulated, T sigma) {
    if (!(accumulated.y >= T(1) && accumulated.y <= T(16777216))) return T(1);
    return gloam_visibility(T(5) * sigma * (accumulated.x / accumulated.y));
}

template <class T>
T gloam_visibility_deep(vec2<T> accumulated, T power) {
    if (!(accumulated.y >= T(1) && accumulated.y <= T(16777216))) return T(1);
    const T open = gloam_visibility(gloam_sqrt(T(3) * (accumulated.x / accumulated.y)));
    return gloam_remap(open, T(0), T(1), power);
}

}  // namespace gloam::reference
