// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/occlusion/falloff.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_contribution_aksoy_phaneuf(vec3<T> offset, vec3<T> normal, T radius, T bias) {
    const bool in_front = gloam_is_finite3(offset) && dot(offset, normal) > bias;
    return in_front ? gloam_falloff_linear(gloam_length(offset), radius) : T(0);
}

template <class T>
T gloam_two_radii_sum(T fine, T broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), T(1));
}

}  // namespace gloam::reference
