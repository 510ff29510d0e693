// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_DISOCCLUSION_GLSL
#define GLOAM_TEMPORAL_DISOCCLUSION_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"

// whether the history is of the same surface (TSSAO-8): `|d' - d~| < epsilon d', d~ the point's depth in the previous
// camera` [TSSAO (Mattausch et al.), eq 8].
// Whether the surface that the history remembers is the one shaded now (TSSAO-8): |1 - expected / stored| < epsilon,
// as |stored - expected| < epsilon stored. Not symmetric: accepts expected depths in (stored (1 - epsilon), stored (1
// + epsilon)).
// stored_depth: d_(f-1), eye-linear, read without interpolation at the reprojected point, world units.
// expected_depth: depth that the current surface point had in the previous camera (gloam_previous_depth), world
// units. Its depth in the current camera would reject every pixel of a camera that moves forward.
// epsilon: relative, 0.01 to 0.05; at 0, negative or NaN nothing passes.
// Returns false as well if either depth is background or NaN (both: see gloam_both_background). A difference within
// rounding of the threshold may fall to either side. Depths above 1e-30.
bool gloam_depth_consistent(float stored_depth, float expected_depth, float epsilon) {
    // An infinite depth differs by infinity or NaN, which is below nothing.
    bool surfaces = stored_depth >= GLOAM_SMALLEST && expected_depth >= GLOAM_SMALLEST;
    return surfaces && abs(stored_depth - expected_depth) < epsilon * stored_depth;
}

// whether there was nothing before and is nothing now (TSSAO-8-background): `both depths background` [TSSAO (Mattausch
// et al.), edge of eq 8].
// Whether there was nothing before and is nothing now: valid, with no occlusion to compute.
// stored_depth: eye-linear depth of the history. expected_depth: as above, or the current depth. World units.
// Returns true if both are background. Error: none.
// No method or pass here calls it: it is there to be copied.
bool gloam_both_background(float stored_depth, float expected_depth) {
    return gloam_is_background(stored_depth) && gloam_is_background(expected_depth);
}

#endif
