// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/length_ratio.hpp"
#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_fox_compton(vec3<T> position, vec3<T> normal, vec3<T> sample_position, T epsilon) {
    const vec3<T> offset = sample_position - position;
    const T cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > T(0) && epsilon <= float_max<T>())) return T(0);
    const T reach = dot(offset, gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0))));
    return cosine / clamp(reach > epsilon ? reach : epsilon, float_min<T>(), T(0x1p126));
}

template <class T>
T gloam_contribution_fox_compton_scaled(vec3<T> position, vec3<T> normal, vec3<T> sample_position,
                                        T epsilon) {
    const vec3<T> offset = sample_position - position;
    const T cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > T(0) && epsilon > T(0))) return T(0);
    const T reach = dot(offset, gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0))));
    return reach > epsilon ? cosine * gloam_length_ratio(epsilon, reach) : cosine;
}

}  // namespace gloam::reference
