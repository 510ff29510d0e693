// SPDX-License-Identifier: MIT
#ifndef BUILTIN_ELEMENTARY_GLSL
#define BUILTIN_ELEMENTARY_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

float builtin_exp(float x) {
    return exp(x);
}
float builtin_exp2(float x) {
    return exp2(x);
}
float builtin_log(float x) {
    return log(x);
}
float builtin_log2(float x) {
    return log2(x);
}
float builtin_inversesqrt(float x) {
    return inversesqrt(x);
}
float builtin_sqrt(float x) {
    return sqrt(x);
}
float builtin_radians(float x) {
    return radians(x);
}
float builtin_degrees(float x) {
    return degrees(x);
}
float builtin_sin(float x) {
    return sin(x);
}
float builtin_cos(float x) {
    return cos(x);
}
float builtin_tan(float x) {
    return tan(x);
}
float builtin_asin(float x) {
    return asin(x);
}
float builtin_acos(float x) {
    return acos(x);
}
float builtin_atan(float x) {
    return atan(x);
}
float builtin_sinh(float x) {
    return sinh(x);
}
float builtin_cosh(float x) {
    return cosh(x);
}
float builtin_tanh(float x) {
    return tanh(x);
}
float builtin_pow(float x, float y) {
    return pow(x, y);
}
float builtin_atan2(float y, float x) {
    return atan(y, x);
}

#endif
