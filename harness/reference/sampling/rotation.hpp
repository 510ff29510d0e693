// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"

namespace gloam::reference {

// The matrix of the rotation with that cosine and sine.
inline dvec2 gloam_turn_disc(dvec2 s, dvec2 turn) {
    return dmat2(turn.x, turn.y, -turn.y, turn.x) * s;
}

inline dvec3 gloam_turn_hemisphere(dvec3 s, dvec2 turn) {
    return {gloam_turn_disc(s, turn), s.z};
}

inline dvec2 gloam_rotate_disc(dvec2 s, double angle) {
    return gloam_turn_disc(s, gloam_sincos(angle));
}

inline dvec3 gloam_rotate_hemisphere(dvec3 s, double angle) {
    return gloam_turn_hemisphere(s, gloam_sincos(angle));
}

}  // namespace gloam::reference
