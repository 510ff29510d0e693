// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/cosine.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_mssao(vec3<T> offset, vec3<T> normal, T radius) {
    return gloam_falloff_quadratic(gloam_length(offset), radius) * gloam_sample_cosine(offset, normal);
}

template <class T>
T gloam_mssao_combine(T largest, T mean) {
    const T a = gloam_unit_interval(largest);
    const T b = gloam_unit_interval(mean);
    return min(a + b * (T(1) - a), T(1));
}

}  // namespace gloam::reference
