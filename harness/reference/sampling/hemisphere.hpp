// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_hemisphere_cosine(vec3<T> zeta) {
    const T alpha = T(2) * pi<T>() * gloam_unit_interval(zeta.x);
    const T r = gloam_unit_interval(zeta.y);
    const T z = gloam_unit_interval(zeta.z);
    return vec3<T>(r * cos(alpha) * sqrt(T(1) - z), r * sin(alpha) * sqrt(T(1) - z), r * sqrt(z));
}

template <class T>
vec3<T> gloam_hemisphere_uniform(vec3<T> zeta) {
    const T alpha = T(2) * pi<T>() * gloam_unit_interval(zeta.x);
    const T r = gloam_unit_interval(zeta.y);
    const T z = gloam_unit_interval(zeta.z);
    return vec3<T>(r * cos(alpha) * sqrt(T(1) - z * z), r * sin(alpha) * sqrt(T(1) - z * z), r * z);
}

}  // namespace gloam::reference
