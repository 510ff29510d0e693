// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

#include "reference/math.hpp"

// What only the references of GLSL's own functions need of mathematics; other number types bring theirs, as
// they do for reference/math.hpp.
namespace gloam::reference {

template <std::floating_point T>
T fma(T a, T b, T c) {
    return std::fma(a, b, c);
}
// Half to even, whatever the rounding mode.
template <std::floating_point T>
T round_even(T x) {
    const T down = std::floor(x);
    const T rest = x - down;
    if (rest != T(0.5)) return std::round(x);
    return std::fmod(down, T(2)) == T(0) ? down : down + T(1);
}
template <std::floating_point T>
T ldexp(T x, int exponent) {
    return std::ldexp(x, exponent);
}
template <std::floating_point T>
T smoothstep(T edge0, T edge1, T x) {
    const T t = clamp((x - edge0) / (edge1 - edge0), T(0), T(1));
    return t * t * (T(3) - T(2) * t);
}
template <std::floating_point T>
T radians(T degrees) {
    return degrees * (pi<T>() / T(180));
}
template <std::floating_point T>
T degrees(T radians) {
    return radians * (T(180) / pi<T>());
}
template <std::floating_point T>
T sinh(T x) {
    return std::sinh(x);
}
template <std::floating_point T>
T cosh(T x) {
    return std::cosh(x);
}
template <std::floating_point T>
T tanh(T x) {
    return std::tanh(x);
}
template <std::floating_point T>
bool is_nan(T x) {
    return std::isnan(x);
}
template <std::floating_point T>
bool is_infinite(T x) {
    return std::isinf(x);
}

// The nearest float16, half to even.
template <std::floating_point T>
T quantize_to_half(T x) {
    if (!(std::abs(x) < T(65520))) return std::isnan(x) ? x : std::copysign(infinity<T>(), x);
    const int exponent = std::max(x == T(0) ? -14 : std::ilogb(x), -14);
    const T unit = std::ldexp(T(1), exponent - 10);
    return round_even(x / unit) * unit;
}

// A result of which Vulkan says nothing: in double what it should be, else anything at all.
template <class T>
T unspecified(T expected) {
    if constexpr (builtin_number<T>) {
        return expected;
    } else {
        return T::anything();
    }
}

}  // namespace gloam::reference
