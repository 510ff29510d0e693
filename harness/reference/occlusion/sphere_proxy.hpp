// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/numeric/length_ratio.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

template <class T>
T gloam_sphere_fraction(T radius, T distance_to) {
    if (!(radius > T(0) && distance_to >= T(0))) return T(0);
    if (distance_to <= radius) return T(1);
    const T x = gloam_length_ratio(radius, distance_to);
    const T gap = gloam_length_ratio(distance_to - radius, distance_to);
    return min(x * x / (T(1) + gloam_sqrt(gap * (T(1) + x))), T(1));
}

template <class T>
T gloam_contribution_sphere(vec3<T> offset, vec3<T> normal, T radius) {
    if (!gloam_is_finite3(offset)) return T(0);
    const T reach = gloam_length(offset);
    const T fraction = gloam_sphere_fraction(radius, reach);
    return reach <= radius ? fraction : fraction * gloam_sample_cosine(offset, normal);
}

template <class T>
T gloam_contribution_sphere_cosine(vec3<T> offset, vec3<T> normal, T radius) {
    if (!(gloam_is_finite3(offset) && radius > T(0))) return T(0);
    const T reach = gloam_length(offset);
    if (reach <= radius) return T(1);
    const T x = gloam_length_ratio(radius, reach);
    return x * x * gloam_sample_cosine(offset, normal);
}

template <class T>
T gloam_above_horizon(vec3<T> offset, T tan_horizon) {
    const T across = gloam_length(vec3<T>(offset.x, offset.y, T(0)));
    const T horizon = across > T(0) ? across * tan_horizon : T(0);
    return gloam_is_finite3(offset) && offset.z > horizon ? T(1) : T(0);
}

}  // namespace gloam::reference
