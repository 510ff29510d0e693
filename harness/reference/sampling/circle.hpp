// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_circle_point(T turn) {
    return gloam_sincos_turns(gloam_unit_interval(turn));
}

}  // namespace gloam::reference
