// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_disc_sample(vec2<T> zeta) {
    const T alpha = T(2) * pi<T>() * gloam_unit_interval(zeta.x);
    const T r = sqrt(gloam_unit_interval(zeta.y));
    return vec2<T>(r * cos(alpha), r * sin(alpha));
}

}  // namespace gloam::reference
