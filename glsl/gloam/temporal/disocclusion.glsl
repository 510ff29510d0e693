// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_DISOCCLUSION_GLSL
#define GLOAM_TEMPORAL_DISOCCLUSION_GLSL

#include "gloam/numeric/constants.glsl"

// whether the history is of the same surface (TSSAO-8): `|d' - d~| < epsilon d', d~ the point's depth in the previous
// camera` [TSSAO, eq 8].
// Not symmetric: accepts expected depths in (stored (1 - epsilon), stored (1 + epsilon)).
// stored_depth: d_(f-1), eye-linear, read without interpolation at the reprojected point, world units.
// expected_depth: depth that the current surface point had in the previous camera (gloam_previous_depth), world
// units. Its depth in the current camera would reject every pixel of a camera that moves forward.
// epsilon: relative, 0.01 to 0.05; at 0, negative or NaN nothing passes.
// Returns false as well if either depth is background or NaN. A difference within rounding of the threshold may fall to
// either side. Depths above 1e-30.
bool gloam_depth_consistent(float stored_depth, float expected_depth, float epsilon) {
    // An infinite depth differs by infinity or NaN, which is below nothing.
    bool surfaces = stored_depth >= GLOAM_SMALLEST && expected_depth >= GLOAM_SMALLEST;
    return surfaces && abs(stored_depth - expected_depth) < epsilon * stored_depth;
}

#endif
