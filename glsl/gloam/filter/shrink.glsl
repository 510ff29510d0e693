// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_SHRINK_GLSL
#define GLOAM_FILTER_SHRINK_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/sampling/unit_interval.glsl"

// factor on the filter's support (TSSAO-11): `s = max(c - conv, 0) / c` [TSSAO, eq 11].
// Pixels that have converged are not filtered.
// convergence: conv; below 0 it is read as 0, NaN gives 1. c_adaptive: c, 0.2: the convergence from which nothing is
// filtered.
// Returns a factor in [0, 1]: 1 for no convergence, falling linearly to 0 at c. 0 for c below 1e-30, negative or NaN;
// 1 for c above 2^126 and conv below it. Error: 3 ULP.
float gloam_shrink(float convergence, float c_adaptive) {
    if (!(c_adaptive >= 1e-30) || convergence >= c_adaptive) return 0.0;
    if (!(convergence > 0.0) || c_adaptive > GLOAM_LARGEST_DIVISOR) return 1.0;
    return min((c_adaptive - convergence) / c_adaptive, 1.0);
}

// how much of a pixel lies in the filter's window (TSSAO-11-window): `clamp(reach + 1 - |i|, 0, 1)` [derived: overlap
// of a pixel with a window of half width reach + 1/2].
// The window reaches from the middle of the centre pixel to `reach` pixels beyond it and half a pixel more on either
// side; a pixel counts by the part covered. No pixel counts twice, whatever the shrink factor, and a reach of n gives n
// whole pixels on each side. The result changes smoothly as the window shrinks. Fewer taps spread over rounded
// positions would do neither.
// offset: distance from the centre pixel, 1 or more. reach: half width of the window in pixels, >= 0.
// Returns clamp(reach - (offset - 1), 0, 1); 0 for NaN. Error: none for offsets up to 2^24.
float gloam_window_coverage(int offset, float reach) {
    return gloam_unit_interval(reach - float(offset - 1));
}

#endif
