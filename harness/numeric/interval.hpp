// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>

#include "numeric/bounds.hpp"

// A number type with which a function computes all results that Vulkan's precision rules permit ("Precision
// and Operation of SPIR-V Instructions"). The format (float32 or float16) is that of the running
// Paths::explore(). Each operation's rule gives the exact range and its error. Rounding (either neighbour),
// the flush of subnormals and overflow are applied in one function, enclose().
//
// A template over the number type works with it unchanged. It has arithmetic, comparisons (an undecided one
// explores both answers, see Paths), and the functions of GLSL, found by argument-dependent lookup.
namespace gloam::numeric {

class Interval {
  public:
    constexpr Interval() = default;

    // A constant of the program: the nearest float32, as a compiler writes it into the module.
    explicit Interval(double constant);
    // An integer converted to floating point.
    template <std::integral Integer>
    explicit Interval(Integer value) : Interval(converted(static_cast<double>(value))) {}

    // An input of the function: exactly this value, or also zero for a subnormal.
    [[nodiscard]] static Interval input(float value);
    // Any of these values; the bounds are not rounded.
    [[nodiscard]] static constexpr Interval within(const Bounds& bounds) { return Interval(bounds); }
    [[nodiscard]] static constexpr Interval within(double low, double high) {
        return Interval(Bounds{low, high, false});
    }
    [[nodiscard]] static constexpr Interval anything() { return Interval(Bounds::anything()); }

    [[nodiscard]] constexpr const Bounds& bounds() const { return bounds_; }
    [[nodiscard]] constexpr double low() const { return bounds_.low; }
    [[nodiscard]] constexpr double high() const { return bounds_.high; }
    [[nodiscard]] constexpr bool may_be_nan() const { return bounds_.nan; }

    Interval& operator+=(const Interval& b);
    Interval& operator-=(const Interval& b);
    Interval& operator*=(const Interval& b);
    Interval& operator/=(const Interval& b);

  private:
    explicit constexpr Interval(const Bounds& bounds) : bounds_(bounds) {}
    [[nodiscard]] static Interval converted(double integer);

    Bounds bounds_;
};

// Arithmetic.
[[nodiscard]] Interval operator+(const Interval& x);
[[nodiscard]] Interval operator-(const Interval& x);
[[nodiscard]] Interval operator+(const Interval& a, const Interval& b);
[[nodiscard]] Interval operator-(const Interval& a, const Interval& b);
[[nodiscard]] Interval operator*(const Interval& a, const Interval& b);
[[nodiscard]] Interval operator/(const Interval& a, const Interval& b);
[[nodiscard]] Interval fma(const Interval& a, const Interval& b, const Interval& c);

// Comparisons: false with NaN, as in IEEE 754 (!= true).
[[nodiscard]] bool operator<(const Interval& a, const Interval& b);
[[nodiscard]] bool operator<=(const Interval& a, const Interval& b);
[[nodiscard]] bool operator>(const Interval& a, const Interval& b);
[[nodiscard]] bool operator>=(const Interval& a, const Interval& b);
[[nodiscard]] bool operator==(const Interval& a, const Interval& b);
[[nodiscard]] bool operator!=(const Interval& a, const Interval& b);
[[nodiscard]] bool is_nan(const Interval& x);
[[nodiscard]] bool is_infinite(const Interval& x);
[[nodiscard]] bool is_finite(const Interval& x);

// Exact: the result is one of the operands, or an integer.
[[nodiscard]] Interval abs(const Interval& x);
[[nodiscard]] Interval sign(const Interval& x);
[[nodiscard]] Interval min(const Interval& a, const Interval& b);
[[nodiscard]] Interval max(const Interval& a, const Interval& b);
[[nodiscard]] Interval clamp(const Interval& x, const Interval& low, const Interval& high);
[[nodiscard]] Interval step(const Interval& edge, const Interval& x);
[[nodiscard]] Interval floor(const Interval& x);
[[nodiscard]] Interval ceil(const Interval& x);
[[nodiscard]] Interval trunc(const Interval& x);
[[nodiscard]] Interval round(const Interval& x);  // a half goes either way
[[nodiscard]] Interval round_even(const Interval& x);

// Conversion to an integer, towards zero. Each possible integer is explored in turn. Undetermined for NaN,
// for values outside int, and if there are more than a few integers.
[[nodiscard]] int to_int(const Interval& x);
[[nodiscard]] unsigned to_uint(const Interval& x);
// The bits of each possible float32, explored in the same way; both zeros if zero is possible.
[[nodiscard]] std::uint32_t to_bits(const Interval& x);

// Correctly rounded, or inherited from a formula.
[[nodiscard]] Interval fract(const Interval& x);
[[nodiscard]] Interval mod(const Interval& x, const Interval& y);
[[nodiscard]] Interval remainder(const Interval& x, const Interval& y);  // OpFRem
[[nodiscard]] Interval mix(const Interval& a, const Interval& b, const Interval& t);
[[nodiscard]] Interval smoothstep(const Interval& edge0, const Interval& edge1, const Interval& x);
[[nodiscard]] Interval ldexp(const Interval& x, int exponent);
[[nodiscard]] Interval radians(const Interval& x);
[[nodiscard]] Interval degrees(const Interval& x);
[[nodiscard]] Interval quantize_to_half(const Interval& x);

// With an error rule of their own, or inherited from functions with one.
[[nodiscard]] Interval inversesqrt(const Interval& x);
[[nodiscard]] Interval sqrt(const Interval& x);
[[nodiscard]] Interval exp(const Interval& x);
[[nodiscard]] Interval exp2(const Interval& x);
[[nodiscard]] Interval log(const Interval& x);
[[nodiscard]] Interval log2(const Interval& x);
[[nodiscard]] Interval pow(const Interval& x, const Interval& y);
[[nodiscard]] Interval sin(const Interval& x);
[[nodiscard]] Interval cos(const Interval& x);
[[nodiscard]] Interval tan(const Interval& x);
[[nodiscard]] Interval asin(const Interval& x);
[[nodiscard]] Interval acos(const Interval& x);
[[nodiscard]] Interval atan(const Interval& x);
[[nodiscard]] Interval atan(const Interval& y, const Interval& x);
[[nodiscard]] Interval sinh(const Interval& x);
[[nodiscard]] Interval cosh(const Interval& x);
[[nodiscard]] Interval tanh(const Interval& x);
[[nodiscard]] Interval asinh(const Interval& x);
[[nodiscard]] Interval acosh(const Interval& x);
[[nodiscard]] Interval atanh(const Interval& x);

// The results of several permitted algorithms: their union. A gap between two results is explored, not
// filled.
[[nodiscard]] Interval any_of(const Interval& a, const Interval& b);

// All results of an operation whose exact results are in `exact`: both neighbours of a value that the format
// cannot represent, zero for a subnormal value, the largest value or infinity beyond the range. Only this
// function applies rounding.
[[nodiscard]] Interval enclose(const Bounds& exact);

}  // namespace gloam::numeric
