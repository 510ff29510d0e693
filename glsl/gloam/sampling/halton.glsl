// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HALTON_GLSL
#define GLOAM_SAMPLING_HALTON_GLSL

#include "gloam/sampling/radical_inverse.glsl"

// point of the Halton sequence, bases 2 and 3 (HALTON-2D): `(Phi_2(i), Phi_3(i))` [Halton 1960; kernels of TSSAO-13].
// index: number of the point, modulo 2^24. Start at 1: point 0 is the origin, which every map sends onto the shaded
// point.
// Returns a point in [0, 1)^2. Error: at most 2 ulp.
vec2 gloam_halton_2d(uint index) {
    return vec2(gloam_radical_inverse_base2(index), gloam_radical_inverse(index, 3u));
}

// point of the Halton sequence, bases 2, 3 and 5 (HALTON-3D): `(Phi_2(i), Phi_3(i), Phi_5(i))` [Halton 1960; kernels of
// TSSAO-14].
// index: number of the point, modulo 2^24. Start at 1: point 0 is the origin, which every map sends onto the shaded
// point.
// Returns a point in [0, 1)^3. Error: at most 2 ulp.
vec3 gloam_halton_3d(uint index) {
    return vec3(gloam_halton_2d(index), gloam_radical_inverse(index, 5u));
}

#endif
