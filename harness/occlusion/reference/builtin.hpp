// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/math.hpp"

// The operators and functions of GLSL themselves, each by that of the standard library or of GLM, and the
// probes.
namespace gloam::reference {

// Half to even, whatever the rounding mode.
inline double round_even(double x) {
    const double down = std::floor(x);
    if (x - down != 0.5) return std::round(x);
    return std::fmod(down, 2.0) == 0.0 ? down : down + 1.0;
}

// The nearest float16, half to even.
inline double quantize_to_half(double x) {
    if (!(std::abs(x) < 65520.0)) return std::isnan(x) ? x : std::copysign(infinity, x);
    const int exponent = std::max(x == 0.0 ? -14 : std::ilogb(x), -14);
    const double unit = std::ldexp(1.0, exponent - 10);
    return round_even(x / unit) * unit;
}

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

inline double builtin_float_of_int(int i) {
    return i;
}
inline double builtin_float_of_uint(unsigned i) {
    return i;
}
inline int builtin_int_of_float(double x) {
    return int(x);
}
inline unsigned builtin_uint_of_float(double x) {
    return unsigned(x);
}
inline bool builtin_isnan(double x) {
    return std::isnan(x);
}
inline bool builtin_isinf(double x) {
    return std::isinf(x);
}
inline bool builtin_less(double x, double y) {
    return x < y;
}
inline bool builtin_less_or_equal(double x, double y) {
    return x <= y;
}
inline bool builtin_equal(double x, double y) {
    return x == y;
}
inline bool builtin_not_equal(double x, double y) {
    return x != y;
}

inline double builtin_exp(double x) {
    return exp(x);
}
inline double builtin_exp2(double x) {
    return exp2(x);
}
inline double builtin_log(double x) {
    return log(x);
}
inline double builtin_log2(double x) {
    return log2(x);
}
inline double builtin_inversesqrt(double x) {
    return 1.0 / sqrt(x);
}
inline double builtin_sqrt(double x) {
    return sqrt(x);
}
inline double builtin_radians(double x) {
    return glm::radians(x);
}
inline double builtin_degrees(double x) {
    return glm::degrees(x);
}
inline double builtin_sin(double x) {
    return sin(x);
}
inline double builtin_cos(double x) {
    return cos(x);
}
inline double builtin_tan(double x) {
    return tan(x);
}
inline double builtin_asin(double x) {
    return asin(x);
}
inline double builtin_acos(double x) {
    return acos(x);
}
inline double builtin_atan(double x) {
    return atan(x);
}
inline double builtin_sinh(double x) {
    return std::sinh(x);
}
inline double builtin_cosh(double x) {
    return std::cosh(x);
}
inline double builtin_tanh(double x) {
    return std::tanh(x);
}
inline double builtin_pow(double x, double y) {
    return pow(x, y);
}
inline double builtin_atan2(double y, double x) {
    return std::atan2(y, x);
}

inline double builtin_dot(dvec3 a, dvec3 b) {
    return dot(a, b);
}
inline double builtin_length(dvec3 v) {
    return length(v);
}
inline double builtin_distance(dvec3 a, dvec3 b) {
    return distance(a, b);
}
inline dvec3 builtin_normalize(dvec3 v) {
    return normalize(v);
}
inline dvec3 builtin_cross(dvec3 a, dvec3 b) {
    return cross(a, b);
}
inline dvec3 builtin_reflect(dvec3 incident, dvec3 normal) {
    return glm::reflect(incident, normal);
}
inline dvec3 builtin_refract(dvec3 incident, dvec3 normal, double eta) {
    return glm::refract(incident, normal, eta);
}
inline dvec3 builtin_faceforward(dvec3 normal, dvec3 incident, dvec3 side) {
    if (dot(side, incident) < 0.0) return normal;
    return -normal;
}

// Rows of the matrix times the vector.
inline dvec3 builtin_matrix_vector(dmat3 m, dvec3 v) {
    return m * v;
}
inline dvec3 builtin_vector_matrix(dvec3 v, dmat3 m) {
    return v * m;
}
inline dmat3 builtin_matrix_matrix(dmat3 a, dmat3 b) {
    return a * b;
}
inline dvec4 builtin_matrix4_vector(dmat4 m, dvec4 v) {
    return m * v;
}
inline dmat3 builtin_outer_product(dvec3 a, dvec3 b) {
    return glm::outerProduct(a, b);
}
inline double builtin_determinant(dmat3 m) {
    return glm::determinant(m);
}
inline dmat3 builtin_inverse(dmat3 m) {
    return glm::inverse(m);
}

// What the probes should return; where Vulkan leaves it open, the reference in double says what one would
// wish.

inline bool probe_isnan_of_difference(double x) {
    return std::isnan(x - x);
}
inline bool probe_differs_from_itself(double x) {
    return std::isnan(x);
}
inline double probe_contraction(double, double, double) {
    return 0.0;
}
inline double probe_precise_in_struct(double, double, double) {
    return 0.0;
}
inline double probe_fma_rounding(double, double, double) {
    return 0.0;
}
// Bit i: component i has its sign bit set.
inline double probe_normalize_sign(dvec3 v) {
    return std::signbit(v.x) * 1.0 + std::signbit(v.y) * 2.0 + std::signbit(v.z) * 4.0;
}
inline double probe_folded_exp(double half) {
    return exp(0.5) - exp(half);
}
inline double probe_folded_sin(double half) {
    return sin(0.5) - sin(half);
}
inline double probe_pow_of_zeros(double x, double y) {
    return pow(x, y);
}
inline int probe_integer_remainder(int) {
    return 0;
}

}  // namespace gloam::reference
