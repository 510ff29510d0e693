// SPDX-License-Identifier: MIT
#pragma once

#include "reference/builtin/math.hpp"

// The operators and functions of GLSL themselves, each by that of the standard library or of GLM.
namespace gloam::reference {

inline double builtin_negate(double x) {
    return -x;
}
inline double builtin_abs(double x) {
    return abs(x);
}
inline double builtin_sign(double x) {
    return glm::sign(x);
}
inline double builtin_min(double x, double y) {
    return min(x, y);
}
inline double builtin_max(double x, double y) {
    return max(x, y);
}
inline double builtin_clamp(double x, double low, double high) {
    return clamp(x, low, high);
}
inline double builtin_add(double x, double y) {
    return x + y;
}
inline double builtin_subtract(double x, double y) {
    return x - y;
}
inline double builtin_multiply(double x, double y) {
    return x * y;
}
inline double builtin_divide(double x, double y) {
    return x / y;
}
inline double builtin_fma(double a, double b, double c) {
    return std::fma(a, b, c);
}
inline double builtin_floor(double x) {
    return floor(x);
}
inline double builtin_ceil(double x) {
    return ceil(x);
}
inline double builtin_fract(double x) {
    return fract(x);
}
inline double builtin_trunc(double x) {
    return std::trunc(x);
}
inline double builtin_round(double x) {
    return std::round(x);
}
inline double builtin_round_even(double x) {
    return round_even(x);
}
inline double builtin_mod(double x, double y) {
    return glm::mod(x, y);
}
inline double builtin_modf(double x, double& whole) {
    whole = std::trunc(x);
    return x - whole;
}
inline double builtin_frexp(double x, int& exponent) {
    return std::frexp(x, &exponent);
}
inline double builtin_ldexp(double x, int exponent) {
    return std::ldexp(x, exponent);
}
inline double builtin_step(double edge, double x) {
    return glm::step(edge, x);
}
inline double builtin_mix(double x, double y, double a) {
    return mix(x, y, a);
}
inline double builtin_smoothstep(double edge0, double edge1, double x) {
    return glm::smoothstep(edge0, edge1, x);
}
inline double builtin_quantize(double x) {
    return quantize_to_half(x);
}

}  // namespace gloam::reference
