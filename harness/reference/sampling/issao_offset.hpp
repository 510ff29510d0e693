// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_issao_offset_polar(vec2<T> e, T radius) {
    const vec2<T> p = gloam_sincos_turns(gloam_unit_interval(e.y));
    return (vec2<T>(p.y, p.x) * gloam_unit_interval(e.x)) * radius;
}

template <class T>
vec2<T> gloam_issao_offset_printed(vec2<T> e, T radius) {
    const vec2<T> u(gloam_unit_interval(e.x), gloam_unit_interval(e.y));
    const vec2<T> offset = u * vec2<T>(gloam_sincos_turns(u.y).y, gloam_sincos_turns(u.x).x);
    const T squared = dot(offset, offset);
    return (squared > T(1) ? vec2<T>(offset / gloam_sqrt(squared)) : offset) * radius;
}

}  // namespace gloam::reference
