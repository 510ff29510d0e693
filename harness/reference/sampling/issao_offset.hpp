// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec2 gloam_issao_offset_polar(dvec2 e, double radius) {
    const dvec2 p = gloam_sincos_turns(gloam_unit_interval(e.y));
    return (dvec2(p.y, p.x) * gloam_unit_interval(e.x)) * radius;
}

inline dvec2 gloam_issao_offset_printed(dvec2 e, double radius) {
    const dvec2 u(gloam_unit_interval(e.x), gloam_unit_interval(e.y));
    const dvec2 offset = u * dvec2(gloam_sincos_turns(u.y).y, gloam_sincos_turns(u.x).x);
    const double squared = dot(offset, offset);
    return (squared > 1.0 ? dvec2(offset / gloam_sqrt(squared)) : offset) * radius;
}

}  // namespace gloam::reference
