// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FILION_GLSL
#define GLOAM_OCCLUSION_FILION_GLSL

#include "gloam/occlusion/gather_kernel.glsl"

// contribution of a sample point, after Filion and McNaughton (CS-B): `1 - clamp((D - R) / D, 0, 1), D = d_s - d_b > 0`
// [Filion and McNaughton 2008].
// Contribution of a point of the half ball: D is how far the surface at the sample's pixel lies in front of it. Blocked
// down to R in front, opening again as R / D beyond. The simple variant that is open beyond R is gloam_sample_blocked.
// sample_depth, buffer_depth: eye-linear, world units. radius: R, world units, > 0.
// Returns occlusion in [0, 1]: 0 for D <= 0 (where the printed quotient divides by 0), 1 for 0 < D <= R, R / D
// beyond. 0 for background in the buffer, as gloam_tap_sees reads it, and for NaN. Error: 2.5 ULP, and what the
// difference of two depths loses.
float gloam_contribution_filion(float sample_depth, float buffer_depth, float radius) {
    float in_front = sample_depth - buffer_depth;
    float opened = in_front > radius ? radius / in_front : 1.0;
    return gloam_tap_sees(buffer_depth) && in_front > 0.0 ? opened : 0.0;
}

#endif
