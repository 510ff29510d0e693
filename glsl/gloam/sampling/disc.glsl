// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_DISC_GLSL
#define GLOAM_SAMPLING_DISC_GLSL

#include "gloam/numeric/square_root.glsl"
#include "gloam/sampling/circle.glsl"

// Uniform point of the unit disc (TSSAO-13, Fox-Compton kernel): angle 2 pi zeta_x, radius sqrt(zeta_y).
// zeta: uniform point of [0, 1)^2 (a Halton point); coordinates outside are taken to the nearer end, NaN to 0.
// Returns a point of the unit disc of density 1 / pi; scale it by the projected radius. zeta_y = 0 gives the centre.
// Error: 3e-7.
vec2 gloam_disc_sample(vec2 zeta) {
    return gloam_sqrt(gloam_unit_interval(zeta.y)) * gloam_circle_point(zeta.x);
}

#endif
