// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HALTON_POINT_GLSL
#define GLOAM_SAMPLING_HALTON_POINT_GLSL

#include "gloam/sampling/radical_inverse.glsl"

// point of a sample: halton (POINTS-halton): `HALTON in bases 2, 3, 5` [TSSAO, eqs 13 and 14].
// Point of the three-dimensional Halton sequence (HALTON), of which slices and rays are made.
// index: number of the point, 1 for the first. Returns a point in [0, 1)^3. Error: at most 2 ulp.
vec3 gloam_halton_point(uint index) {
    return vec3(gloam_radical_inverse_base2(index), gloam_radical_inverse(index, 3u), gloam_radical_inverse(index, 5u));
}

#endif
