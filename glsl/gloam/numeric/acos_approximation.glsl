// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_ACOS_APPROXIMATION_GLSL
#define GLOAM_NUMERIC_ACOS_APPROXIMATION_GLSL

#include "gloam/numeric/constants.glsl"

// Arc cosine by a polynomial in x and |x|, as the angle-based method of UE4 uses it. All are right at -1, 0 and 1 and
// symmetric about (0, pi / 2); gloam_acos is the function itself.

// cosine taken into its range (CS-P-cosine): `clamp(x, -1, 1)` [Mittring 2012; Aalund and Baerentzen 2013].
// x: any float.
// Returns x, the nearer end outside; 0 for NaN. Error: none.
// No method or pass here calls it: it is there to be copied.
float gloam_clamp_cosine(float x) {
    return abs(x) <= 1.0 ? x : (x > 1.0 ? 1.0 : (x < -1.0 ? -1.0 : 0.0));
}

// arc cosine, linear approximation (CS-P-acos-linear): `pi (1 - x) / 2` [Mittring 2012; Aalund and Baerentzen 2013].
// Up to 0.3307 rad from acos.
// x: cosine; taken to the nearer end outside [-1, 1], NaN to 0.
// Returns radians in [0, pi]. Error against its own formula: 3.5e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_acos_linear(float x) {
    return GLOAM_HALF_PI - GLOAM_HALF_PI * gloam_clamp_cosine(x);
}

// arc cosine, quadratic approximation (CS-P-acos-quadratic): `pi (1 - sgn(x) x^2) / 2` [Mittring 2012; Aalund and
// Baerentzen 2013].
// Up to 0.165337 rad from acos.
// x: cosine; taken to the nearer end outside [-1, 1], NaN to 0.
// Returns radians in [0, pi]. Error against its own formula: 4e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_acos_quadratic(float x) {
    float c = gloam_clamp_cosine(x);
    return GLOAM_HALF_PI - GLOAM_HALF_PI * (c * abs(c));
}

// arc cosine, cubic approximation (CS-P-acos-cubic): `((-2 pi / 9) x^2 - 5 pi / 18) x + pi / 2` [Mittring 2012; Aalund
// and Baerentzen 2013].
// Cubic: ((-2 pi / 9) x^2 - 5 pi / 18) x + pi / 2, which also passes through acos at -1/2 and 1/2. Up to 0.178758 rad
// (10.2 degrees) from acos, at |x| = 0.9275. The copy at hand prints its first constant as -0-69813.
// x: cosine; taken to the nearer end outside [-1, 1], NaN to 0.
// Returns radians in [0, pi]. Error against its own formula: 4e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_acos_cubic(float x) {
    float c = gloam_clamp_cosine(x);
    return clamp((-0.6981317008 * (c * c) - 0.8726646260) * c + GLOAM_HALF_PI, 0.0, GLOAM_PI);
}

#endif
