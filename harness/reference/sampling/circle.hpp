// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_circle_point(T turn) {
    const T angle = T(2) * pi<T>() * gloam_unit_interval(turn);
    return vec2<T>(cos(angle), sin(angle));
}

}  // namespace gloam::reference
