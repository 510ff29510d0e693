// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_circle_point(T turn) {
    if constexpr (exact_number<T>) {
        const T angle = T(2) * pi<T>() * gloam_unit_interval(turn);
        return vec2<T>(cos(angle), sin(angle));
    }
    const T angle = (gloam_unit_interval(turn) - T(0.5)) * T(6.283185005);
    return -vec2<T>(cos(angle), sin(angle));
}

}  // namespace gloam::reference
