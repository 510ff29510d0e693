// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_ACOS_APPROXIMATION_GLSL
#define GLOAM_NUMERIC_ACOS_APPROXIMATION_GLSL

#include "gloam/numeric/constants.glsl"

// arc cosine, cubic approximation (CS-P-acos-cubic): `((-2 pi / 9) x^2 - 5 pi / 18) x + pi / 2` [Mittring 2012; Aalund
// and Baerentzen 2013].
// As the angle-based method of UE4 has it: right at -1, -1/2, 0, 1/2 and 1, up to 0.178758 rad (10.2 degrees) from
// acos, at |x| = 0.9275. The copy at hand prints its first constant as -0-69813.
// x: cosine; taken to the nearer end outside [-1, 1], NaN to 0.
// Returns radians in [0, pi]. Error against its own formula: 4e-7.
// No method or pass here calls it: it is the angle of the comparative study; the methods take gloam_unit_angle.
float gloam_acos_cubic(float x) {
    float c = abs(x) <= 1.0 ? x : (x > 1.0 ? 1.0 : (x < -1.0 ? -1.0 : 0.0));
    return clamp((-0.6981317008 * (c * c) - 0.8726646260) * c + GLOAM_HALF_PI, 0.0, GLOAM_PI);
}

#endif
