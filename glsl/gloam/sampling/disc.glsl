// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_DISC_GLSL
#define GLOAM_SAMPLING_DISC_GLSL

#include "gloam/numeric/sincos.glsl"
#include "gloam/numeric/square_root.glsl"

// uniform point of the disc (TSSAO-13): `a = 2 pi zeta_x, r = sqrt(zeta_y); s = (r cos a, r sin a)` [TSSAO,
// eq 13; Fox and Compton's kernel].
// The Fox-Compton kernel.
// zeta: uniform point of [0, 1)^2 (a Halton point). Outside, zeta_x counts modulo 1 and zeta_y is taken to the nearer
// end; NaN counts as 0, an infinite zeta_x too.
// Returns a point of the unit disc of density 1 / pi; scale it by the projected radius. zeta_y = 0 gives the centre.
// Error: 3e-7.
vec2 gloam_disc_sample(vec2 zeta) {
    return min(gloam_sqrt(zeta.y), 1.0) * gloam_sincos_turns(zeta.x);
}

#endif
