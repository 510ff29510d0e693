// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <glm/glm.hpp>

// The mathematics that the references are written in: plain double, the standard library's functions and
// GLM's. A reference states an equation as its source prints it, or the definition behind it, and shares no
// order of operations with the shader. What a shader returns for zero, infinite and NaN input, as its comment
// promises, stands in a reference as a line of its own.
namespace gloam::reference {

using glm::abs, std::abs;
using glm::clamp, glm::cross, glm::distance, glm::dmat2, glm::dmat3, glm::dmat4, glm::dot, glm::dvec2,
    glm::dvec3, glm::dvec4, glm::length, glm::max, glm::min, glm::mix, glm::normalize, glm::transpose;
using glm::floor, std::floor;
using std::acos, std::asin, std::atan, std::cos, std::exp, std::exp2, std::pow, std::sin, std::sqrt, std::tan;

inline constexpr double pi = std::numbers::pi;
inline constexpr double infinity = std::numeric_limits<double>::infinity();
// The largest finite float32, and the smallest normal one: a device may read a smaller number as zero.
inline constexpr double float_max = 0x1.fffffep127;
inline constexpr double float_min = 0x1p-126;

// The fractional part, in [0, 1).
inline double fract(double x) {
    return x - std::floor(x);
}

// Finite as a float: what only a wider type can hold counts as infinite.
inline bool is_finite(double x) {
    return abs(x) <= float_max;
}
// As a device may read it: a subnormal number is 0.
inline double flushed(double x) {
    return abs(x) < float_min ? 0.0 : x;
}
template <glm::length_t N>
bool is_finite(const glm::vec<N, double>& v) {
    for (glm::length_t i = 0; i < N; ++i)
        if (!is_finite(v[i])) return false;
    return true;
}

// Whether an image of that size has the pixel.
inline bool has_pixel(glm::ivec2 size, glm::ivec2 pixel) {
    return pixel == clamp(pixel, glm::ivec2(0), size - 1);
}

// The image that a GLSL prototype reads: the value at a pixel.
template <class Value>
using Fetch = std::function<Value(glm::ivec2)>;

}  // namespace gloam::reference
