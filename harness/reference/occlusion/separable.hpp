// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/gaussian.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_separable_mean(T along_u, T along_v) {
    return T(0.5) * (gloam_unit_interval(along_u) + gloam_unit_interval(along_v));
}

template <class T>
T gloam_separable_weight(vec3<T> offset, vec3<T> normal, T sigma, T tolerance) {
    const bool on_plane = abs(dot(offset, normal)) <= tolerance;
    return on_plane ? gloam_gaussian(dot(offset, offset), sigma) : T(0);
}

}  // namespace gloam::reference
