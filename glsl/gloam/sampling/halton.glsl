// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HALTON_GLSL
#define GLOAM_SAMPLING_HALTON_GLSL

// radical inverse in base 2 (HALTON-base2): `Phi_2(i) = sum of a_m 2^(-m-1), i = sum of a_m 2^m` [van der Corput 1935;
// Halton 1960].
// The digits a_m of the index mirrored at the point.
// index: number of the sample; only its 24 low bits count (index modulo 2^24).
// Returns a multiple of 2^-24 in [0, 1). Error: none.
float gloam_radical_inverse_base2(uint index) {
#if (defined(GL_ES) && __VERSION__ >= 310) || (!defined(GL_ES) && __VERSION__ >= 400)
    uint bits = bitfieldReverse(index);
#else
    uint bits = (index << 16u) | (index >> 16u);
    bits = ((bits & 0x00FF00FFu) << 8u) | ((bits >> 8u) & 0x00FF00FFu);
    bits = ((bits & 0x0F0F0F0Fu) << 4u) | ((bits >> 4u) & 0x0F0F0F0Fu);
    bits = ((bits & 0x33333333u) << 2u) | ((bits >> 2u) & 0x33333333u);
    bits = ((bits & 0x55555555u) << 1u) | ((bits >> 1u) & 0x55555555u);
#endif
    // 24 bits fit a float; all 32 would round up to 1. Each half of them also fits a float of half precision.
    return float(bits >> 20u) * 0.000244140625 + float((bits >> 8u) & 0xFFFu) * 5.9604644775390625e-8;
}

// radical inverse in any base (HALTON): `Phi_b(i) = sum of a_m b^(-m-1), i = sum of a_m b^m` [Halton 1960].
// index: number of the sample; only its 24 low bits count (index modulo 2^24).
// base: 2 to 2^24, taken to the nearer end outside; the Halton bases are primes.
// Returns a number in [0, 1). Error: at most 3 ulp.
float gloam_radical_inverse(uint index, uint base) {
    uint radix = clamp(base, 2u, 0x01000000u);
    uint rest = index & 0x00FFFFFFu;
    uint mirrored = 0u;
    uint power = 1u;
    // All digits but the last are summed as integers that a float holds exactly, so that no error builds up.
    for (; rest >= radix; rest /= radix, power *= radix) mirrored = mirrored * radix + rest % radix;
    float inverse = (float(mirrored) + float(rest) / float(radix)) / float(power);
    return min(inverse, 0.999999940395355);  // rounding must not reach 1
}

// point of the Halton sequence, bases 2 and 3 (HALTON-2D): `(Phi_2(i), Phi_3(i))` [Halton 1960; kernels of TSSAO-13].
// index: number of the point, modulo 2^24. Start at 1: point 0 is the origin, which every map sends onto the shaded
// point.
// Returns a point in [0, 1)^2. Error: at most 3 ulp.
vec2 gloam_halton_2d(uint index) {
    return vec2(gloam_radical_inverse_base2(index), gloam_radical_inverse(index, 3u));
}

// point of the Halton sequence, bases 2, 3 and 5 (HALTON-3D): `(Phi_2(i), Phi_3(i), Phi_5(i))` [Halton 1960; kernels of
// TSSAO-14].
// index: as for gloam_halton_2d. Returns a point in [0, 1)^3. Error: at most 3 ulp.
vec3 gloam_halton_3d(uint index) {
    return vec3(gloam_halton_2d(index), gloam_radical_inverse(index, 5u));
}

// point of a sample: halton (POINTS-halton): `HALTON in bases 2, 3, 5` [TSSAO, eqs 13 and 14].
// Point of the three-dimensional Halton sequence (HALTON), of which slices and rays are made.
// index: number of the point, 1 for the first. Returns a point in [0, 1)^3. Error: 2e-7.
vec3 gloam_halton_point(uint index) {
    return vec3(gloam_radical_inverse_base2(index), gloam_radical_inverse(index, 3u), gloam_radical_inverse(index, 5u));
}

#endif
