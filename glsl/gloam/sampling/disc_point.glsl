// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_DISC_POINT_GLSL
#define GLOAM_SAMPLING_DISC_POINT_GLSL

#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/halton.glsl"

// point of a sample: disc (POINTS-disc): `TSSAO-13 of the Halton point` [TSSAO, eqs 13 and 14].
// Point of the unit disc before it is rotated (TSSAO-13): what all pixels share of a tap (halton.glsl).
// index: number of the Halton point, 1 for the first. Returns the point in xy; z is 0. Error: 5e-7.
vec3 gloam_disc_point(uint index) {
    return vec3(gloam_disc_sample(gloam_halton_2d(index)), 0.0);
}

#endif
