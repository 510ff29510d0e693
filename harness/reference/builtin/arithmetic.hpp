// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

// The operators and functions of GLSL themselves, each by the number type's own operation of that name.
namespace gloam::reference {

template <class T>
T builtin_negate(T x) {
    return -x;
}
template <class T>
T builtin_abs(T x) {
    return abs(x);
}
template <class T>
T builtin_sign(T x) {
    return sign(x);
}
template <class T>
T builtin_min(T x, T y) {
    return min(x, y);
}
template <class T>
T builtin_max(T x, T y) {
    return max(x, y);
}
template <class T>
T builtin_clamp(T x, T low, T high) {
    return clamp(x, low, high);
}
template <class T>
T builtin_add(T x, T y) {
    return x + y;
}
template <class T>
T builtin_subtract(T x, T y) {
    return x - y;
}
template <class T>
T builtin_multiply(T x, T y) {
    return x * y;
}
template <class T>
T builtin_divide(T x, T y) {
    return x / y;
}
template <class T>
T builtin_fma(T a, T b, T c) {
    return fma(a, b, c);
}
template <class T>
T builtin_floor(T x) {
    return floor(x);
}
template <class T>
T builtin_ceil(T x) {
    return ceil(x);
}
template <class T>
T builtin_fract(T x) {
    return fract(x);
}
template <class T>
T builtin_trunc(T x) {
    return trunc(x);
}
template <class T>
T builtin_round(T x) {
    return round(x);
}
template <class T>
T builtin_round_even(T x) {
    return round_even(x);
}
template <class T>
T builtin_mod(T x, T y) {
    return mod(x, y);
}
template <class T>
T builtin_modf(T x, T& whole) {
    whole = trunc(x);
    return x - whole;
}
// By halving and doubling, which are exact; 0 and subnormal numbers give (0, 0).
template <class T>
T builtin_frexp(T x, int& exponent) {
    exponent = 0;
    if (!(abs(x) >= float_min<T>())) return T(0);
    for (; abs(x) >= T(1); ++exponent) x = x * T(0.5);
    for (; abs(x) < T(0.5); --exponent) x = x * T(2);
    return x;
}
template <class T>
T builtin_ldexp(T x, int exponent) {
    return ldexp(x, exponent);
}
template <class T>
T builtin_step(T edge, T x) {
    return step(edge, x);
}
template <class T>
T builtin_mix(T x, T y, T a) {
    return mix(x, y, a);
}
template <class T>
T builtin_smoothstep(T edge0, T edge1, T x) {
    return smoothstep(edge0, edge1, x);
}
template <class T>
T builtin_quantize(T x) {
    return quantize_to_half(x);
}

}  // namespace gloam::reference
