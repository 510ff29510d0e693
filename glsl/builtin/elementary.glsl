// SPDX-License-Identifier: MIT
#ifndef BUILTIN_ELEMENTARY_GLSL
#define BUILTIN_ELEMENTARY_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

// as Vulkan promises: 3 + 2 abs(x) ulp (BUILTIN-exp): `exp(x)` [Vulkan's rules].
float builtin_exp(float x) {
    return exp(x);
}
// as Vulkan promises: 3 + 2 abs(x) ulp (BUILTIN-exp2): `exp2(x)` [Vulkan's rules].
float builtin_exp2(float x) {
    return exp2(x);
}
// as Vulkan promises: 3 ulp outside [0.5, 2], 2^-21 inside (BUILTIN-log): `log(x)` [Vulkan's rules].
float builtin_log(float x) {
    return log(x);
}
// as Vulkan promises: 3 ulp outside [0.5, 2], 2^-21 inside (BUILTIN-log2): `log2(x)` [Vulkan's rules].
float builtin_log2(float x) {
    return log2(x);
}
// as Vulkan promises: 2 ulp (BUILTIN-inversesqrt): `inversesqrt(x)` [Vulkan's rules].
float builtin_inversesqrt(float x) {
    return inversesqrt(x);
}
// as Vulkan promises: inherited from 1 / inversesqrt(x) (BUILTIN-sqrt): `sqrt(x)` [Vulkan's rules].
float builtin_sqrt(float x) {
    return sqrt(x);
}
// as Vulkan promises: x times the rounded constant (BUILTIN-radians): `radians(x)` [Vulkan's rules].
float builtin_radians(float x) {
    return radians(x);
}
// as Vulkan promises: x times the rounded constant (BUILTIN-degrees): `degrees(x)` [Vulkan's rules].
float builtin_degrees(float x) {
    return degrees(x);
}
// as Vulkan promises: 2^-11 absolute in [-pi, pi], nothing outside (BUILTIN-sin): `sin(x)` [Vulkan's rules].
float builtin_sin(float x) {
    return sin(x);
}
// as Vulkan promises: 2^-11 absolute in [-pi, pi], nothing outside (BUILTIN-cos): `cos(x)` [Vulkan's rules].
float builtin_cos(float x) {
    return cos(x);
}
// as Vulkan promises: inherited from sin(x) / cos(x) (BUILTIN-tan): `tan(x)` [Vulkan's rules].
float builtin_tan(float x) {
    return tan(x);
}
// as Vulkan promises: inherited from atan(x, sqrt(1 - x x)) (BUILTIN-asin): `asin(x)` [Vulkan's rules].
float builtin_asin(float x) {
    return asin(x);
}
// as Vulkan promises: inherited from atan(sqrt(1 - x x), x) (BUILTIN-acos): `acos(x)` [Vulkan's rules].
float builtin_acos(float x) {
    return acos(x);
}
// as Vulkan promises: 4096 ulp (BUILTIN-atan): `atan(x)` [Vulkan's rules].
float builtin_atan(float x) {
    return atan(x);
}
// as Vulkan promises: inherited from (exp(x) - exp(-x)) / 2 (BUILTIN-sinh): `sinh(x)` [Vulkan's rules].
float builtin_sinh(float x) {
    return sinh(x);
}
// as Vulkan promises: inherited from (exp(x) + exp(-x)) / 2 (BUILTIN-cosh): `cosh(x)` [Vulkan's rules].
float builtin_cosh(float x) {
    return cosh(x);
}
// as Vulkan promises: inherited from sinh(x) / cosh(x) (BUILTIN-tanh): `tanh(x)` [Vulkan's rules].
float builtin_tanh(float x) {
    return tanh(x);
}
// as Vulkan promises: inherited from exp2(y log2(x)) (BUILTIN-pow): `pow(x, y)` [Vulkan's rules].
float builtin_pow(float x, float y) {
    return pow(x, y);
}
// as Vulkan promises: 4096 ulp (BUILTIN-atan2): `atan(y, x)` [Vulkan's rules].
float builtin_atan2(float y, float x) {
    return atan(y, x);
}

#endif
