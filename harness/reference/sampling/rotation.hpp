// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

inline dvec2 gloam_turn_disc(dvec2 s, dvec2 turn) {
    if (!(dot(s, s) <= 1e38)) return dvec2(0.0);
    return dvec2(turn.x * s.x - turn.y * s.y, turn.y * s.x + turn.x * s.y);
}

inline dvec3 gloam_turn_hemisphere(dvec3 s, dvec2 turn) {
    if (!(dot(s, s) <= 1e38)) return dvec3(0.0);
    const dvec2 side = gloam_turn_disc(dvec2(s.x, s.y), turn);
    return dvec3(side.x, side.y, s.z);
}

inline dvec2 gloam_rotate_disc(dvec2 s, double angle) {
    return gloam_turn_disc(s, gloam_sincos(angle));
}

inline dvec3 gloam_rotate_hemisphere(dvec3 s, double angle) {
    return gloam_turn_hemisphere(s, gloam_sincos(angle));
}

}  // namespace gloam::reference
