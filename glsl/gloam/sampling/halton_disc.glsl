// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HALTON_DISC_GLSL
#define GLOAM_SAMPLING_HALTON_DISC_GLSL

#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/rotation.glsl"

// The point before it is rotated. A pass that has the points in a table defines this macro as what reads it, before it includes this file.
#ifndef GLOAM_DISC_POINT
#define GLOAM_DISC_POINT(index) gloam_disc_sample(gloam_halton_2d(index))
#endif

// Point of the rotated disc kernel: the disc map (TSSAO-13) of a Halton point, turned about the centre (TSSAO-ROT).
// index: number of the Halton point, 1 for the first. turn: (cos, sin) of the kernel's angle, as gloam_sincos gives it: the same for all its points.
// Returns a point of the unit disc; the zero vector for index 0. Error: 5e-7.
vec2 gloam_halton_disc(uint index, vec2 turn) {
    return gloam_turn_disc(GLOAM_DISC_POINT(index), turn);
}

#endif
