// SPDX-License-Identifier: MIT
#ifndef BUILTIN_ARITHMETIC_GLSL
#define BUILTIN_ARITHMETIC_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

float builtin_negate(float x) {
    return -x;
}
float builtin_abs(float x) {
    return abs(x);
}
float builtin_sign(float x) {
    return sign(x);
}
float builtin_min(float x, float y) {
    return min(x, y);
}
float builtin_max(float x, float y) {
    return max(x, y);
}
float builtin_clamp(float x, float low, float high) {
    return clamp(x, low, high);
}
float builtin_add(float x, float y) {
    return x + y;
}
float builtin_subtract(float x, float y) {
    return x - y;
}
float builtin_multiply(float x, float y) {
    return x * y;
}
float builtin_divide(float x, float y) {
    return x / y;
}
float builtin_fma(float a, float b, float c) {
    return fma(a, b, c);
}
float builtin_floor(float x) {
    return floor(x);
}
float builtin_ceil(float x) {
    return ceil(x);
}
float builtin_fract(float x) {
    return fract(x);
}
float builtin_trunc(float x) {
    return trunc(x);
}
float builtin_round(float x) {
    return round(x);
}
float builtin_round_even(float x) {
    return roundEven(x);
}
float builtin_mod(float x, float y) {
    return mod(x, y);
}
float builtin_modf(float x, out float whole) {
    return modf(x, whole);
}
float builtin_frexp(float x, out int exponent) {
    return frexp(x, exponent);
}
float builtin_ldexp(float x, int exponent) {
    return ldexp(x, exponent);
}
float builtin_step(float edge, float x) {
    return step(edge, x);
}
float builtin_mix(float x, float y, float a) {
    return mix(x, y, a);
}
float builtin_smoothstep(float edge0, float edge1, float x) {
    return smoothstep(edge0, edge1, x);
}
float builtin_quantize(float x) {
    return unpackHalf2x16(packHalf2x16(vec2(x, 0.0))).x;
}

#endif
