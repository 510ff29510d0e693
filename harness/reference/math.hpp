// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include <glm/mat2x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

// The mathematics the references are written in. A reference calls these functions unqualified: for the
// built-in types they are found here, for any other number type (an interval, say) by argument-dependent
// lookup in that type's own namespace. Such a type needs the arithmetic operators, comparisons, construction
// from double, and the scalar functions it is used with. Vectors and matrices are GLM's, whose operators
// accept any number type; GLM's functions do not, so they are defined here.
namespace gloam::reference {

template <class T>
using vec2 = glm::vec<2, T>;
template <class T>
using vec3 = glm::vec<3, T>;
template <class T>
using vec4 = glm::vec<4, T>;
template <class T>
using mat2 = glm::mat<2, 2, T>;
template <class T>
using mat3 = glm::mat<3, 3, T>;
template <class T>
using mat4 = glm::mat<4, 4, T>;

template <class T>
concept builtin_number = std::floating_point<T> || std::integral<T>;

// double stands for the real numbers. A reference performs the operations of the shader in their order, so
// that it runs on intervals too; where the shader approximates a function by other means, its result in
// double is that function itself.
template <class T>
concept exact_number = std::same_as<T, double>;

// Constants of a number type; a type that cannot hold pi as a double (an interval) specialises this.
template <class T>
struct constants {
    static T pi() { return T(std::numbers::pi); }
    static T infinity() { return T(std::numeric_limits<double>::infinity()); }
};
template <std::floating_point T>
struct constants<T> {
    static constexpr T pi() { return std::numbers::pi_v<T>; }
    static constexpr T infinity() { return std::numeric_limits<T>::infinity(); }
};

template <class T>
constexpr T pi() {
    return constants<T>::pi();
}
template <class T>
constexpr T infinity() {
    return constants<T>::infinity();
}
// The largest finite float32: where the shaders stop calling a value finite, whatever T is.
template <class T>
constexpr T float_max() {
    return T(static_cast<double>(std::numeric_limits<float>::max()));
}

// The smallest normal float32: the shaders read smaller magnitudes as zero where they say so.
template <class T>
constexpr T float_min() {
    return T(static_cast<double>(std::numeric_limits<float>::min()));
}

// True for numbers that are neither infinite nor NaN.
template <std::floating_point T>
bool is_finite(T x) {
    return std::isfinite(x);
}

// Scalars.

template <builtin_number T>
constexpr T abs(T x) {
    return x < T(0) ? -x : (x == T(0) ? T(0) : x);
}
template <builtin_number T>
constexpr T min(T a, T b) {
    return b < a ? b : a;
}
template <builtin_number T>
constexpr T max(T a, T b) {
    return a < b ? b : a;
}
template <builtin_number T>
constexpr T clamp(T x, T low, T high) {
    return min(max(x, low), high);
}
template <builtin_number T>
constexpr T sign(T x) {
    return x > T(0) ? T(1) : (x < T(0) ? T(-1) : T(0));
}
template <std::floating_point T>
constexpr T step(T edge, T x) {
    return x < edge ? T(0) : T(1);
}
template <std::floating_point T>
constexpr T mix(T a, T b, T t) {
    return a * (T(1) - t) + b * t;
}
template <std::floating_point T>
T sqrt(T x) {
    return std::sqrt(x);
}
template <std::floating_point T>
T inversesqrt(T x) {
    return T(1) / std::sqrt(x);
}
template <std::floating_point T>
T cbrt(T x) {
    return std::cbrt(x);
}
template <std::floating_point T>
T sin(T x) {
    return std::sin(x);
}
template <std::floating_point T>
T cos(T x) {
    return std::cos(x);
}
template <std::floating_point T>
T tan(T x) {
    return std::tan(x);
}
template <std::floating_point T>
T asin(T x) {
    return std::asin(x);
}
template <std::floating_point T>
T acos(T x) {
    return std::acos(x);
}
template <std::floating_point T>
T atan(T x) {
    return std::atan(x);
}
// The angle of the point (x, y), in (-pi, pi].
template <std::floating_point T>
T atan(T y, T x) {
    return std::atan2(y, x);
}
template <std::floating_point T>
T exp(T x) {
    return std::exp(x);
}
template <std::floating_point T>
T exp2(T x) {
    return std::exp2(x);
}
template <std::floating_point T>
T log(T x) {
    return std::log(x);
}
template <std::floating_point T>
T log2(T x) {
    return std::log2(x);
}
template <std::floating_point T>
T pow(T x, T y) {
    return std::pow(x, y);
}
template <std::floating_point T>
T floor(T x) {
    return std::floor(x);
}
template <std::floating_point T>
T ceil(T x) {
    return std::ceil(x);
}
template <std::floating_point T>
T trunc(T x) {
    return std::trunc(x);
}
// Half away from zero; GLSL leaves the direction at .5 to the driver.
template <std::floating_point T>
T round(T x) {
    return std::round(x);
}
template <std::floating_point T>
T fract(T x) {
    return x - std::floor(x);
}
// x - y floor(x / y): the sign of y, as in GLSL.
template <std::floating_point T>
T mod(T x, T y) {
    return x - y * std::floor(x / y);
}

// The integer part. Other number types bring their own.
template <std::floating_point T>
int to_int(T x) {
    return static_cast<int>(x);
}

// Vectors. (The qualifier is left at GLM's default on purpose: it makes these the better match over GLM's own
// templates.)

template <glm::length_t N, class T>
T dot(const glm::vec<N, T>& a, const glm::vec<N, T>& b) {
    T sum = a[0] * b[0];
    for (glm::length_t i = 1; i < N; ++i) sum = sum + a[i] * b[i];
    return sum;
}
template <glm::length_t N, class T>
T length(const glm::vec<N, T>& v) {
    return sqrt(dot(v, v));
}
template <glm::length_t N, class T>
T distance(const glm::vec<N, T>& a, const glm::vec<N, T>& b) {
    return length(a - b);
}
// Undefined for the zero vector, as in GLSL.
template <glm::length_t N, class T>
glm::vec<N, T> normalize(const glm::vec<N, T>& v) {
    return v * inversesqrt(dot(v, v));
}
template <class T>
vec3<T> cross(const vec3<T>& a, const vec3<T>& b) {
    return vec3<T>(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
template <glm::length_t N, class T>
glm::vec<N, T> reflect(const glm::vec<N, T>& incident, const glm::vec<N, T>& normal) {
    return incident - normal * (T(2) * dot(normal, incident));
}

// One scalar function on every component.
template <glm::length_t N, class T, class F>
glm::vec<N, T> map(const glm::vec<N, T>& v, F&& f) {
    glm::vec<N, T> result = v;
    for (glm::length_t i = 0; i < N; ++i) result[i] = f(v[i]);
    return result;
}
template <glm::length_t N, class T>
glm::vec<N, T> abs(const glm::vec<N, T>& v) {
    return map(v, [](const T& x) { return abs(x); });
}
template <glm::length_t N, class T>
glm::vec<N, T> floor(const glm::vec<N, T>& v) {
    return map(v, [](const T& x) { return floor(x); });
}
template <glm::length_t N, class T>
glm::vec<N, T> fract(const glm::vec<N, T>& v) {
    return map(v, [](const T& x) { return fract(x); });
}
template <glm::length_t N, class T>
glm::vec<N, T> min(const glm::vec<N, T>& a, const glm::vec<N, T>& b) {
    glm::vec<N, T> result = a;
    for (glm::length_t i = 0; i < N; ++i) result[i] = min(a[i], b[i]);
    return result;
}
template <glm::length_t N, class T>
glm::vec<N, T> max(const glm::vec<N, T>& a, const glm::vec<N, T>& b) {
    glm::vec<N, T> result = a;
    for (glm::length_t i = 0; i < N; ++i) result[i] = max(a[i], b[i]);
    return result;
}
template <glm::length_t N, class T>
glm::vec<N, T> clamp(const glm::vec<N, T>& v, const glm::vec<N, T>& low, const glm::vec<N, T>& high) {
    return min(max(v, low), high);
}
template <glm::length_t N, class T>
glm::vec<N, T> clamp(const glm::vec<N, T>& v, T low, T high) {
    return map(v, [&](const T& x) { return clamp(x, low, high); });
}
template <glm::length_t N, class T>
glm::vec<N, T> mix(const glm::vec<N, T>& a, const glm::vec<N, T>& b, T t) {
    return a * (T(1) - t) + b * t;
}
template <glm::length_t N, class T>
bool is_finite(const glm::vec<N, T>& v) {
    bool finite = true;
    for (glm::length_t i = 0; i < N; ++i) finite = is_finite(v[i]) && finite;
    return finite;
}

// Matrices: column-major, column vectors.

// Matrix times vector: each component a sum of products, whose order GLSL leaves open as it does for dot().
template <glm::length_t N, class T>
glm::vec<N, T> multiply(const glm::mat<N, N, T>& m, const glm::vec<N, T>& v) {
    glm::vec<N, T> result = v;
    for (glm::length_t row = 0; row < N; ++row) {
        glm::vec<N, T> factors = v;
        for (glm::length_t column = 0; column < N; ++column) factors[column] = m[column][row];
        result[row] = dot(factors, v);
    }
    return result;
}

template <glm::length_t N, class T>
glm::mat<N, N, T> transpose(const glm::mat<N, N, T>& m) {
    glm::mat<N, N, T> result = m;
    for (glm::length_t i = 0; i < N; ++i)
        for (glm::length_t j = 0; j < N; ++j) result[i][j] = m[j][i];
    return result;
}

}  // namespace gloam::reference
