// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_PAIRS_GLSL
#define GLOAM_SAMPLING_PAIRS_GLSL

#include "gloam/numeric/constants.glsl"

// sample of a kernel of opposite pairs (PAIRS): `s_(2m) = s, s_(2m+1) = -s` [Loos and Sloan 2010].
// s: the point of pair m, in the unit disc.
// index: number of the sample, 2 m or 2 m + 1; its lowest bit alone counts.
// Returns s for an even index, -s for an odd one; the zero vector for an infinite or NaN s. Error: none.
// No method or pass here calls it: it is there to be copied.
vec2 gloam_paired_sample(vec2 s, int index) {
    if (!(abs(s.x) <= GLOAM_LARGEST && abs(s.y) <= GLOAM_LARGEST)) return vec2(0.0);
    return (index & 1) == 0 ? s : -s;
}

#endif
