// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_COUNT_BY_DISTANCE_GLSL
#define GLOAM_SAMPLING_COUNT_BY_DISTANCE_GLSL

#include "gloam/numeric/constants.glsl"

// samples by distance (CS-N): `max(int(base / (1 + base d / z_far)), N_min)` [Aalund and Baerentzen 2013].
// Fewer where less is seen of them.
// depth: d, eye-linear, world units; infinite, negative and NaN count as the far plane. z_far: world units, > 0.
// base: samples next to the eye, up to 4096; below 0 counts as 0. least: samples at any distance, N_min.
// Returns a count >= least; least for a base of 0. A depth of 0 gives base, and so does every one with a far plane
// beyond 2^126, which counts as at infinity; a far plane that is zero, negative, subnormal or NaN lies before every
// depth. Error: none, but a quotient within rounding of a whole number may fall to either side.
int gloam_count_by_distance(float depth, float z_far, int base, int least) {
    float start = float(clamp(base, 0, 4096));
    bool placed = depth >= 0.0 && z_far >= GLOAM_SMALLEST && depth < z_far;
    float distance_part = placed ? (z_far <= GLOAM_LARGEST_DIVISOR ? depth / z_far : 0.0) : 1.0;
    return max(int(start / (1.0 + start * distance_part)), least);
}

#endif
