// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_FILION_GLSL
#define GLOAM_OCCLUSION_FILION_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/length_ratio.glsl"

// contribution of a sample point, after Filion and McNaughton (CS-B): `1 - clamp((D - R) / D, 0, 1), D = d_s - d_b > 0`
// [Filion and McNaughton 2008].
// Contribution of a point of the half ball (Filion and McNaughton 2008; gloam_hemisphere_flip makes the points): 1 -
// clamp((D - R) / D, 0, 1) with D how far the surface at the sample's pixel lies in front of it. Blocked down to R in
// front, opening again as R / D beyond. The simple variant that is open beyond R is gloam_sample_blocked.
// sample_depth, buffer_depth: eye-linear, world units. radius: R, world units.
// Returns occlusion in [0, 1]: 0 for D <= 0 (where the printed quotient divides by 0), 1 for 0 < D <= R, R / D
// beyond. 0 for background in the buffer, a sample at or behind the eye, R not positive or subnormal, and NaN. Error:
// 2.5 ULP, and what the difference of two depths loses.
// No method or pass here calls it: it is there to be copied.
float gloam_contribution_filion(float sample_depth, float buffer_depth, float radius) {
    if (gloam_is_background(sample_depth) || gloam_is_background(buffer_depth)) return 0.0;
    float in_front = sample_depth - buffer_depth;
    if (!(in_front >= GLOAM_SMALLEST && radius >= GLOAM_SMALLEST)) return 0.0;
    return in_front <= radius ? 1.0 : gloam_length_ratio(radius, in_front);
}

#endif
