// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_BACKGROUND_GLSL
#define GLOAM_GEOMETRY_BACKGROUND_GLSL

#include "gloam/numeric/constants.glsl"

// number that is neither infinite nor NaN (FINITE): `|x| <= FLT_MAX` [convention].
// A test of the bits, because compilers may take isnan() and isinf() for false, and a comparison for the negation of
// its opposite.
// x: any float. Error: none.
bool gloam_is_finite(float x) {
    return (floatBitsToUint(x) & 0x7F800000u) != 0x7F800000u;
}

// not a number (NAN): `x is NaN` [convention].
// A test of the bits: a driver was seen to take abs(x) >= 0 for true, although it keeps NaN.
// x: any float. Error: none.
bool gloam_is_nan(float x) {
    return (floatBitsToUint(x) & 0x7FFFFFFFu) > 0x7F800000u;
}

// vector that is neither infinite nor NaN (FINITE-2): `|v_i| <= FLT_MAX` [convention].
// v: any vector. Error: none.
bool gloam_is_finite2(vec2 v) {
    return all(notEqual(floatBitsToUint(v) & 0x7F800000u, uvec2(0x7F800000u)));
}

// vector that is neither infinite nor NaN (FINITE-3): `|v_i| <= FLT_MAX` [convention].
// v: any vector. Error: none.
bool gloam_is_finite3(vec3 v) {
    return all(notEqual(floatBitsToUint(v) & 0x7F800000u, uvec3(0x7F800000u)));
}

// vector that is neither infinite nor NaN (FINITE-4): `|v_i| <= FLT_MAX` [convention].
// v: any vector. Error: none.
bool gloam_is_finite4(vec4 v) {
    return all(notEqual(floatBitsToUint(v) & 0x7F800000u, uvec4(0x7F800000u)));
}

// depth of a pixel without geometry (BACKGROUND-depth): `+infinity` [convention].
// Returns +infinity. Error: none.
float gloam_background_depth() {
    return uintBitsToFloat(0x7F800000u);
}

// depth that stands for no geometry (BACKGROUND): `not (0 < d < infinity)` [convention].
// depth: eye-linear depth in world units, d = -z in view space.
// Returns false for a positive finite depth, true for zero, negative, infinite and NaN. A subnormal depth is read as
// 0, so that devices that flush subnormals agree with those that do not. Error: none.
bool gloam_is_background(float depth) {
    return !(depth >= GLOAM_SMALLEST && depth <= GLOAM_LARGEST);
}

#endif
