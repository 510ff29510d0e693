// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLES_DISC_GLSL
#define GLOAM_SAMPLES_DISC_GLSL

#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/halton.glsl"

// Point of the unit disc before it is rotated (TSSAO-13), for gloam_halton_disc.
// index: number of the Halton point, 1 for the first. Returns the point in xy; z is 0.
vec3 gloam_shared_sample(uint index) {
    return vec3(gloam_disc_sample(gloam_halton_2d(index)), 0.0);
}

#endif
