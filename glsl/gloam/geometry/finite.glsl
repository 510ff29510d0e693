// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_FINITE_GLSL
#define GLOAM_GEOMETRY_FINITE_GLSL

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

#endif
