// SPDX-License-Identifier: MIT
#pragma once

#include "reference/occlusion/cosine.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_fox_compton(vec3<T> position, vec3<T> normal, vec3<T> sample_position, T epsilon) {
    const vec3<T> offset = sample_position - position;
    const T cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > T(0)) || !(epsilon <= float_max<T>())) return T(0);
    return cosine / max(epsilon, length(offset));
}

template <class T>
T gloam_contribution_fox_compton_scaled(vec3<T> position, vec3<T> normal, vec3<T> sample_position,
                                        T epsilon) {
    const vec3<T> offset = sample_position - position;
    const T cosine = gloam_sample_cosine(offset, normal);
    if (!(cosine > T(0)) || !(epsilon > T(0))) return T(0);
    if (epsilon > float_max<T>()) return cosine;
    return epsilon * cosine / max(epsilon, length(offset));
}

}  // namespace gloam::reference
