// SPDX-License-Identifier: MIT
#ifndef BUILTIN_COMPARISON_GLSL
#define BUILTIN_COMPARISON_GLSL

// One expression each: what GLSL offers itself, so that a device can be judged by Vulkan's rules for it.

// as Vulkan promises: correctly rounded (BUILTIN-float_of_int): `float(i)` [Vulkan's rules].
float builtin_float_of_int(int i) {
    return float(i);
}
// as Vulkan promises: correctly rounded (BUILTIN-float_of_uint): `float(i)` [Vulkan's rules].
float builtin_float_of_uint(uint i) {
    return float(i);
}
// as Vulkan promises: towards zero (BUILTIN-int_of_float): `int(x)` [Vulkan's rules].
int builtin_int_of_float(float x) {
    return int(x);
}
// as Vulkan promises: towards zero (BUILTIN-uint_of_float): `uint(x)` [Vulkan's rules].
uint builtin_uint_of_float(float x) {
    return uint(x);
}
// as Vulkan promises: correct result (BUILTIN-isnan): `isnan(x)` [Vulkan's rules].
bool builtin_isnan(float x) {
    return isnan(x);
}
// as Vulkan promises: correct result (BUILTIN-isinf): `isinf(x)` [Vulkan's rules].
bool builtin_isinf(float x) {
    return isinf(x);
}
// as Vulkan promises: correct result (BUILTIN-less): `x < y` [Vulkan's rules].
bool builtin_less(float x, float y) {
    return x < y;
}
// as Vulkan promises: correct result (BUILTIN-less_or_equal): `x <= y` [Vulkan's rules].
bool builtin_less_or_equal(float x, float y) {
    return x <= y;
}
// as Vulkan promises: correct result (BUILTIN-equal): `x == y` [Vulkan's rules].
bool builtin_equal(float x, float y) {
    return x == y;
}
// as Vulkan promises: correct result (BUILTIN-not_equal): `x != y` [Vulkan's rules].
bool builtin_not_equal(float x, float y) {
    return x != y;
}

#endif
