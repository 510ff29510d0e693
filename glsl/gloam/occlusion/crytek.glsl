// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_CRYTEK_GLSL
#define GLOAM_OCCLUSION_CRYTEK_GLSL

#include "gloam/occlusion/gather_kernel.glsl"

// Crytek's screen-space ambient occlusion (Mittring 2007; CS-3.1): points of a whole ball around the surface against
// the depth buffer, without falloff. On a plane half of the ball lies in the ground, so the mean is 1/2 (1/4 open in
// an inner corner, 3/4 on an edge): the offset 0.5 of gloam_remap undoes it.

// Crytek's contribution of a sample point (CS-A): `1 - V', V' = 1 if s_d > s_z, else 0` [Mittring 2007; Aalund and
// Baerentzen 2013, eq 3.1].
// Contribution of a sample point, by eye-linear depths: 1 unless the surface at its pixel lies behind it.
// sample_depth: s_z, eye-linear, world units; the sample is p + R s with s in the unit ball, in view space.
// buffer_depth: s_d at its pixel.
// Returns occlusion, 0 or 1: 1 where buffer_depth <= sample_depth, equality included: a bias keeps a plane seen
// head-on from that. 0 for background in the buffer, as gloam_tap_sees reads it, and for NaN. Error: none.
float gloam_contribution_crytek(float sample_depth, float buffer_depth) {
    return gloam_tap_sees(buffer_depth) && buffer_depth <= sample_depth ? 1.0 : 0.0;
}

#endif
