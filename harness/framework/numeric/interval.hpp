// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>

#include "numeric/numbers.hpp"

namespace gloam::numeric {

// A set of results: every real number from low to high, infinities included if they are ends, and NaN if
// `nan` is set. It contains no number if low > high. NaN is stored separately, so that neither hides the
// other.
struct Bounds {
    double low;
    double high;
    bool nan;

    [[nodiscard]] static constexpr Bounds anything() {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), true};
    }
    [[nodiscard]] static constexpr Bounds only_nan() {
        return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), true};
    }
    [[nodiscard]] static constexpr Bounds point(double x) { return {x, x, false}; }

    [[nodiscard]] constexpr bool empty() const { return low > high; }
    [[nodiscard]] constexpr bool is_point() const { return low == high && !nan; }
    [[nodiscard]] constexpr bool is_anything() const {
        return nan && low == -std::numeric_limits<double>::infinity() &&
               high == std::numeric_limits<double>::infinity();
    }
    // Whether a result is in the set.
    [[nodiscard]] constexpr bool contains(double x) const { return x != x ? nan : low <= x && x <= high; }
    [[nodiscard]] constexpr bool contains(const Bounds& other) const {
        return (nan || !other.nan) && (other.empty() || (low <= other.low && other.high <= high));
    }

    friend constexpr bool operator==(const Bounds&, const Bounds&) = default;
};

// The smallest bounds that contain both.
[[nodiscard]] constexpr Bounds hull(const Bounds& a, const Bounds& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), a.nan || b.nan};
}

// A number type with which a function computes all results that Vulkan's precision rules permit ("Precision
// and Operation of SPIR-V Instructions"). The format (float32 or float16) is that of the
// running Paths::explore(). Each operation's rule gives the exact range and its error. Rounding (either
// neighbour), the flush of subnormals and overflow are applied in one function, enclose().
//
// A template over the number type works with it unchanged. It has arithmetic, comparisons (an undecided one
// explores both answers, see Paths), and the functions of GLSL, found by argument-dependent lookup.

class Interval {
  public:
    constexpr Interval() = default;

    // A constant of the program: the nearest float32, as a compiler writes it into the module.
    explicit Interval(double constant);
    // An integer converted to floating point.
    template <std::integral Integer>
        requires(sizeof(Integer) <= sizeof(float))
    explicit Interval(Integer value) {
        *this = converted(value);
    }

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

  private:
    explicit constexpr Interval(const Bounds& bounds) : bounds_(bounds) {}
    [[nodiscard]] static Interval converted(double integer);

    Bounds bounds_;
};

// While it exists, the running thread calculates steps of a formula from which Vulkan lets an operation
// inherit its precision. A step need not be a float, so its bounds in ULP or by an absolute error are rounded
// outwards; those of a result end at the last float inside.
class Formula {
  public:
    Formula() { ++depth_; }
    ~Formula() { --depth_; }
    Formula(const Formula&) = delete;
    Formula& operator=(const Formula&) = delete;

    [[nodiscard]] static bool runs() { return depth_ > 0; }

    // The result of f() as a step.
    template <class F>
    [[nodiscard]] static auto step(F&& f) {
        const Formula formula;
        return f();
    }

  private:
    static thread_local int depth_;
};

// Arithmetic.
[[nodiscard]] Interval operator-(const Interval& x);
[[nodiscard]] Interval operator+(const Interval& a, const Interval& b);
[[nodiscard]] Interval operator-(const Interval& a, const Interval& b);
[[nodiscard]] Interval operator*(const Interval& a, const Interval& b);
[[nodiscard]] Interval operator/(const Interval& a, const Interval& b);
[[nodiscard]] Interval fma(const Interval& a, const Interval& b, const Interval& c);

// Whether it is NaN, or an infinity: nothing else is permitted.
[[nodiscard]] bool is_special(const Interval& x);

// Comparisons: false with NaN, as in IEEE 754 (!= true). Undecided for NaN and infinity if these are not kept
// (Paths::Specials): the first wordings of SignedZeroInfNanPreserve list no comparison, and none a test of
// them.
[[nodiscard]] bool operator<(const Interval& a, const Interval& b);
[[nodiscard]] bool operator<=(const Interval& a, const Interval& b);
[[nodiscard]] bool operator==(const Interval& a, const Interval& b);
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
// for values outside the type, and if there are more than a few integers.
[[nodiscard]] double integer_within(const Interval& x, double least, double most);
template <std::integral Integer>
[[nodiscard]] Integer to_integer(const Interval& x) {
    using Limits = std::numeric_limits<Integer>;
    return static_cast<Integer>(integer_within(x, Limits::min(), Limits::max()));
}
// The bits of each possible float32, explored in the same way; both zeros if zero is possible.
[[nodiscard]] std::uint32_t to_bits(const Interval& x);

// Correctly rounded, or inherited from a formula.
[[nodiscard]] Interval fract(const Interval& x);
[[nodiscard]] Interval mod(const Interval& x, const Interval& y);
[[nodiscard]] Interval remainder(const Interval& x, const Interval& y);  // OpFRem
[[nodiscard]] Interval mix(const Interval& a, const Interval& b, const Interval& t);
[[nodiscard]] Interval smoothstep(const Interval& edge0, const Interval& edge1, const Interval& x);
[[nodiscard]] Interval times_power_of_two(const Interval& x, int exponent);
// The same, but anything beyond the largest exponent or number of the format, and 0 also below the smallest.
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

// The sum of one to four numbers: GLSL's dot and matrix products inherit their precision from that of the
// products in any order, so it is the union over all orders.
[[nodiscard]] Interval sum_in_any_order(std::span<const Interval> p);

}  // namespace gloam::numeric
