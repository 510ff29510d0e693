// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_FINITE_GLSL
#define GLOAM_GEOMETRY_FINITE_GLSL

// Whether a number is neither infinite nor NaN. A comparison, because compilers may take isnan() and isinf() for false.
// x: any float. Error: none. OpenGL keeps no rules of NaN: compiled by Mesa's OpenGL, it may return true for NaN.
bool gloam_is_finite(float x) {
    return abs(x) <= 3.402823466e38;
}

// Whether both components are neither infinite nor NaN.
// v: any vector. Error: none.
bool gloam_is_finite2(vec2 v) {
    return all(lessThanEqual(abs(v), vec2(3.402823466e38)));
}

// Whether all three components are neither infinite nor NaN.
// v: any vector. Error: none.
bool gloam_is_finite3(vec3 v) {
    return all(lessThanEqual(abs(v), vec3(3.402823466e38)));
}

// Whether all four components are neither infinite nor NaN.
// v: any vector. Error: none.
// No method or pass here calls it: it is there to be copied.
bool gloam_is_finite4(vec4 v) {
    return all(lessThanEqual(abs(v), vec4(3.402823466e38)));
}

#endif
