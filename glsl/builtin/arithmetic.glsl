// SPDX-License-Identifier: MIT
#ifndef BUILTIN_ARITHMETIC_GLSL
#define BUILTIN_ARITHMETIC_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

// as Vulkan promises: correct result (BUILTIN-negate): `-x` [Vulkan's rules].
float builtin_negate(float x) {
    return -x;
}
// as Vulkan promises: correct result (BUILTIN-abs): `abs(x)` [Vulkan's rules].
float builtin_abs(float x) {
    return abs(x);
}
// as Vulkan promises: correct result (BUILTIN-sign): `sign(x)` [Vulkan's rules].
float builtin_sign(float x) {
    return sign(x);
}
// as Vulkan promises: correct result (BUILTIN-min): `min(x, y)` [Vulkan's rules].
float builtin_min(float x, float y) {
    return min(x, y);
}
// as Vulkan promises: correct result (BUILTIN-max): `max(x, y)` [Vulkan's rules].
float builtin_max(float x, float y) {
    return max(x, y);
}
// as Vulkan promises: correct result (BUILTIN-clamp): `clamp(x, low, high)` [Vulkan's rules].
float builtin_clamp(float x, float low, float high) {
    return clamp(x, low, high);
}
// as Vulkan promises: correctly rounded (BUILTIN-add): `x + y` [Vulkan's rules].
float builtin_add(float x, float y) {
    return x + y;
}
// as Vulkan promises: correctly rounded (BUILTIN-subtract): `x - y` [Vulkan's rules].
float builtin_subtract(float x, float y) {
    return x - y;
}
// as Vulkan promises: correctly rounded (BUILTIN-multiply): `x * y` [Vulkan's rules].
float builtin_multiply(float x, float y) {
    return x * y;
}
// as Vulkan promises: 2.5 ulp for abs(y) in [2^-126, 2^126] (BUILTIN-divide): `x / y` [Vulkan's rules].
float builtin_divide(float x, float y) {
    return x / y;
}
// as Vulkan promises: inherited from a multiply, then an add (BUILTIN-fma): `fma(a, b, c)` [Vulkan's rules].
float builtin_fma(float a, float b, float c) {
    return fma(a, b, c);
}
// as Vulkan promises: correctly rounded (BUILTIN-floor): `floor(x)` [Vulkan's rules].
float builtin_floor(float x) {
    return floor(x);
}
// as Vulkan promises: correctly rounded (BUILTIN-ceil): `ceil(x)` [Vulkan's rules].
float builtin_ceil(float x) {
    return ceil(x);
}
// as Vulkan promises: correctly rounded (BUILTIN-fract): `fract(x)` [Vulkan's rules].
float builtin_fract(float x) {
    return fract(x);
}
// as Vulkan promises: correctly rounded (BUILTIN-trunc): `trunc(x)` [Vulkan's rules].
float builtin_trunc(float x) {
    return trunc(x);
}
// as Vulkan promises: correctly rounded, a half either way (BUILTIN-round): `round(x)` [Vulkan's rules].
float builtin_round(float x) {
    return round(x);
}
// as Vulkan promises: correctly rounded (BUILTIN-round_even): `roundEven(x)` [Vulkan's rules].
float builtin_round_even(float x) {
    return roundEven(x);
}
// as Vulkan promises: inherited from x - y floor(x / y) (BUILTIN-mod): `mod(x, y)` [Vulkan's rules].
float builtin_mod(float x, float y) {
    return mod(x, y);
}
// as Vulkan promises: correctly rounded (BUILTIN-modf): `modf(x, whole)` [Vulkan's rules].
float builtin_modf(float x, out float whole) {
    return modf(x, whole);
}
// as Vulkan promises: correct result (BUILTIN-frexp): `frexp(x, exponent)` [Vulkan's rules].
float builtin_frexp(float x, out int exponent) {
    return frexp(x, exponent);
}
// as Vulkan promises: correctly rounded (BUILTIN-ldexp): `ldexp(x, exponent)` [Vulkan's rules].
float builtin_ldexp(float x, int exponent) {
    return ldexp(x, exponent);
}
// as Vulkan promises: correctly rounded (BUILTIN-step): `step(x, y)` [Vulkan's rules].
float builtin_step(float edge, float x) {
    return step(edge, x);
}
// as Vulkan promises: inherited from x (1 - a) + y a (BUILTIN-mix): `mix(x, y, a)` [Vulkan's rules].
float builtin_mix(float x, float y, float a) {
    return mix(x, y, a);
}
// as Vulkan promises: inherited from t t (3 - 2 t) (BUILTIN-smoothstep): `smoothstep(e0, e1, x)` [Vulkan's rules].
float builtin_smoothstep(float edge0, float edge1, float x) {
    return smoothstep(edge0, edge1, x);
}
// as Vulkan promises: correctly rounded to float16 (BUILTIN-quantize): `unpackHalf2x16(packHalf2x16(vec2(x, 0))).x`
// [Vulkan's rules].
float builtin_quantize(float x) {
    return unpackHalf2x16(packHalf2x16(vec2(x, 0.0))).x;
}

#endif
