// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/circle.hpp"

namespace gloam::reference {

inline dvec2 gloam_issao_offset_polar(dvec2 e, double radius) {
    const double angle = 2.0 * pi * gloam_unit_interval(e.y);
    return radius * gloam_unit_interval(e.x) * dvec2(sin(angle), cos(angle));
}

// Beyond the disc: its nearest point.
inline dvec2 gloam_issao_offset_printed(dvec2 e, double radius) {
    const dvec2 u(gloam_unit_interval(e.x), gloam_unit_interval(e.y));
    const dvec2 printed(u.x * sin(2.0 * pi * u.y), u.y * cos(2.0 * pi * u.x));
    return radius * printed / max(length(printed), 1.0);
}

}  // namespace gloam::reference
