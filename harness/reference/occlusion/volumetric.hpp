// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"

namespace gloam::reference {

template <class T>
T gloam_chord_half_height(vec2<T> xi, T radius) {
    const T height = radius * gloam_sqrt(T(1) - dot(xi, xi));
    return height > T(0) ? height : T(0);
}

template <class T>
T gloam_line_occlusion(T height, T half_height) {
    if (!(half_height >= float_min<T>() && half_height <= T(0x1p126))) return T(0.5);
    if (height >= half_height) return T(1);
    if (height <= -half_height) return T(0);
    return abs(height) < half_height ? T(0.5) + T(0.5) * (height / half_height) : T(0.5);
}

// The place of the surface on a line from the far end (0) of the chord to its near end (1).
template <class T>
T gloam_line_ratio(T height, T half_height) {
    if (!(half_height >= float_min<T>() && half_height <= T(0x1p126))) return T(0.5);
    const T ratio = T(0.5) + T(0.5) * (height / half_height);
    return abs(ratio) >= T(0) ? ratio : T(0.5);
}

template <class T>
vec2<T> gloam_line_pair(vec2<T> ratios, T lowest, T highest) {
    const bool first = ratios.x >= lowest && ratios.x <= highest;
    const bool second = ratios.y >= lowest && ratios.y <= highest;
    if (first && second) return ratios;
    if (first) return vec2<T>(ratios.x, T(1) - ratios.x);
    return second ? vec2<T>(T(1) - ratios.y, ratios.y) : vec2<T>(T(0.5), T(0.5));
}

template <class T>
T gloam_tangent_sphere_half_height(vec3<T> offset, vec3<T> normal, T radius) {
    if (!(radius >= float_min<T>() && radius <= T(0x1p126))) return T(0);
    const T half_radius = T(0.5) * radius;
    const vec2<T> xi = vec2<T>(offset.x, offset.y) / half_radius - vec2<T>(normal.x, normal.y);
    const T height = half_radius * gloam_sqrt(T(1) - dot(xi, xi));
    return height > T(0) ? height : T(0);
}

template <class T>
T gloam_tangent_sphere_occlusion(vec3<T> offset, vec3<T> normal, T radius) {
    const T half_height = gloam_tangent_sphere_half_height(offset, normal, radius);
    const T height = offset.z - T(0.5) * radius * normal.z;
    return half_height >= float_min<T>() && abs(height) >= T(0) ? gloam_line_occlusion(height, half_height)
                                                                : T(0);
}

}  // namespace gloam::reference
