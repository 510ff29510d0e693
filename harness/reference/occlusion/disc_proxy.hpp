// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/numeric/length_ratio.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_disc_share(T area, T distance_to) {
    const T radius = gloam_sqrt(area * (exact_number<T> ? T(1) / pi<T>() : T(0.318309886)));
    if (!(radius > T(0) && distance_to >= T(0))) return vec2<T>(T(0), T(1));
    const bool wide = radius > distance_to;
    const T x = gloam_length_ratio(wide ? distance_to : radius, wide ? radius : distance_to);
    const T larger = T(1) / (T(1) + x * x);
    const T smaller = x * x / (T(1) + x * x);
    return min(wide ? vec2<T>(larger, smaller) : vec2<T>(smaller, larger), vec2<T>(T(1), T(1)));
}

template <class T>
T gloam_contribution_disc_proxy(vec3<T> offset, vec3<T> normal, vec3<T> emitter_normal, T area, T weight) {
    const vec2<T> share = gloam_disc_share(area, gloam_length(offset));
    const vec3<T> back(-offset.x, -offset.y, -offset.z);
    const T facing =
        gloam_sample_cosine(back, emitter_normal) * min(T(4) * gloam_sample_cosine(offset, normal), T(1));
    return gloam_unit_interval(weight) * facing * (share.x / (T(1) + gloam_sqrt(share.y)));
}

template <class T>
T gloam_contribution_disc_proxy_cosine(vec3<T> offset, vec3<T> normal, vec3<T> emitter_normal, T area,
                                       T weight) {
    const T share = gloam_disc_share(area, gloam_length(offset)).x;
    const vec3<T> back(-offset.x, -offset.y, -offset.z);
    return gloam_unit_interval(weight) * share * gloam_sample_cosine(back, emitter_normal) *
           gloam_sample_cosine(offset, normal);
}

}  // namespace gloam::reference
