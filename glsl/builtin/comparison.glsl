// SPDX-License-Identifier: MIT
#ifndef BUILTIN_COMPARISON_GLSL
#define BUILTIN_COMPARISON_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

float builtin_float_of_int(int i) {
    return float(i);
}
float builtin_float_of_uint(uint i) {
    return float(i);
}
int builtin_int_of_float(float x) {
    return int(x);
}
uint builtin_uint_of_float(float x) {
    return uint(x);
}
bool builtin_isnan(float x) {
    return isnan(x);
}
bool builtin_isinf(float x) {
    return isinf(x);
}
bool builtin_less(float x, float y) {
    return x < y;
}
bool builtin_less_or_equal(float x, float y) {
    return x <= y;
}
bool builtin_equal(float x, float y) {
    return x == y;
}
bool builtin_not_equal(float x, float y) {
    return x != y;
}

#endif
