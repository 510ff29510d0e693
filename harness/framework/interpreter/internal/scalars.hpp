// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <numbers>

#include "numeric/interval.hpp"

// The functions of GLSL on float and double, with the names that they have for numeric::Interval, so that one
// template serves every number type; and each operation as a function object, a template over the number
// type: float, double or numeric::Interval.
namespace gloam::interpreter::internal {
namespace scalars {

template <class T>
concept Real = std::same_as<T, float> || std::same_as<T, double>;

}

#define GLOAM_FUNCTION(Name, function)         \
    struct Name {                              \
        template <class... N>                  \
        auto operator()(const N&... x) const { \
            using namespace scalars;           \
            return function(x...);             \
        }                                      \
    };
#define GLOAM_OF_REALS(Name, Result, function, operands, expression) \
    namespace scalars {                                              \
    template <Real T>                                                \
    Result function operands {                                       \
        return expression;                                           \
    }                                                                \
    }                                                                \
    GLOAM_FUNCTION(Name, function)
// A float result is computed in double and rounded once.
#define GLOAM_BY_DOUBLE(Name, function, expression)   \
    namespace scalars {                               \
    template <Real T>                                 \
    T function(T argument) {                          \
        const auto x = static_cast<double>(argument); \
        return static_cast<T>(expression);            \
    }                                                 \
    }                                                 \
    GLOAM_FUNCTION(Name, function)
#define GLOAM_OPERATOR(Name, symbol)                    \
    struct Name {                                       \
        template <class N>                              \
        auto operator()(const N& x, const N& y) const { \
            return x symbol y;                          \
        }                                               \
    };

GLOAM_BY_DOUBLE(Sqrt, sqrt, std::sqrt(x))
GLOAM_BY_DOUBLE(InverseSqrt, inversesqrt, 1.0 / std::sqrt(x))
GLOAM_BY_DOUBLE(Sin, sin, std::sin(x))
GLOAM_BY_DOUBLE(Cos, cos, std::cos(x))
GLOAM_BY_DOUBLE(Tan, tan, std::tan(x))
GLOAM_BY_DOUBLE(Asin, asin, std::asin(x))
GLOAM_BY_DOUBLE(Acos, acos, std::acos(x))
GLOAM_BY_DOUBLE(Atan, atan, std::atan(x))
GLOAM_BY_DOUBLE(Sinh, sinh, std::sinh(x))
GLOAM_BY_DOUBLE(Cosh, cosh, std::cosh(x))
GLOAM_BY_DOUBLE(Tanh, tanh, std::tanh(x))
GLOAM_BY_DOUBLE(Asinh, asinh, std::asinh(x))
GLOAM_BY_DOUBLE(Acosh, acosh, std::acosh(x))
GLOAM_BY_DOUBLE(Atanh, atanh, std::atanh(x))
GLOAM_BY_DOUBLE(Exp, exp, std::exp(x))
GLOAM_BY_DOUBLE(Exp2, exp2, std::exp2(x))
GLOAM_BY_DOUBLE(Log, log, std::log(x))
GLOAM_BY_DOUBLE(Log2, log2, std::log2(x))
GLOAM_BY_DOUBLE(Floor, floor, std::floor(x))
GLOAM_BY_DOUBLE(Ceil, ceil, std::ceil(x))
GLOAM_BY_DOUBLE(Trunc, trunc, std::trunc(x))
GLOAM_BY_DOUBLE(Round, round, std::round(x))
GLOAM_BY_DOUBLE(RoundEven, round_even, std::nearbyint(x))
GLOAM_BY_DOUBLE(Radians, radians, x*(std::numbers::pi / 180.0))
GLOAM_BY_DOUBLE(Degrees, degrees, x * (180.0 / std::numbers::pi))

GLOAM_OF_REALS(Atan2, T, atan, (T y, T x),
               static_cast<T>(std::atan2(static_cast<double>(y), static_cast<double>(x))))
GLOAM_OF_REALS(Pow, T, pow, (T x, T y),
               static_cast<T>(std::pow(static_cast<double>(x), static_cast<double>(y))))
GLOAM_OF_REALS(Abs, T, abs, (T x), std::abs(x))
GLOAM_OF_REALS(Sign, T, sign, (T x), x > T(0) ? T(1) : (x < T(0) ? T(-1) : x))
GLOAM_OF_REALS(Min, T, min, (T a, T b), b < a || std::isnan(a) ? b : a)
GLOAM_OF_REALS(Max, T, max, (T a, T b), a < b || std::isnan(a) ? b : a)
GLOAM_OF_REALS(Clamp, T, clamp, (T x, T low, T high), scalars::min(scalars::max(x, low), high))
GLOAM_OF_REALS(StepAt, T, step, (T edge, T x), x < edge ? T(0) : T(1))
GLOAM_OF_REALS(Fract, T, fract, (T x), x - std::floor(x))
GLOAM_OF_REALS(Mod, T, mod, (T x, T y), x - y * std::floor(x / y))
GLOAM_OF_REALS(Remainder, T, remainder, (T x, T y), x - y * std::trunc(x / y))
GLOAM_OF_REALS(Mix, T, mix, (T a, T b, T t), a*(T(1) - t) + b * t)
GLOAM_OF_REALS(Fma, T, fma, (T a, T b, T c), std::fma(a, b, c))
GLOAM_OF_REALS(IsNan, bool, is_nan, (T x), std::isnan(x))
GLOAM_OF_REALS(IsInfinite, bool, is_infinite, (T x), std::isinf(x))

namespace scalars {

template <Real T>
T smoothstep(T edge0, T edge1, T x) {
    const T t = scalars::clamp((x - edge0) / (edge1 - edge0), T(0), T(1));
    return t * t * (T(3) - T(2) * t);
}
template <Real T>
T ldexp(T x, int exponent) {
    return std::ldexp(x, exponent);
}
// Rounds towards zero. A value out of range is undefined in SPIR-V; it becomes the nearest representable one,
// and NaN becomes zero.
template <std::integral I, Real T>
I to_integer(T argument) {
    const auto x = static_cast<double>(argument);
    if (std::isnan(x) || x <= static_cast<double>(std::numeric_limits<I>::min()))
        return std::isnan(x) ? I{0} : std::numeric_limits<I>::min();
    return x >= static_cast<double>(std::numeric_limits<I>::max()) ? std::numeric_limits<I>::max()
                                                                   : static_cast<I>(x);
}
// The nearest half, ties to even.
template <Real T>
T quantize_to_half(T x) {
    const auto value = static_cast<double>(x);
    if (!std::isfinite(value)) return x;
    constexpr int digits = 11;
    constexpr int least_exponent = -14;
    const int exponent = value == 0.0 ? least_exponent : std::max(std::ilogb(value), least_exponent);
    const double unit = std::ldexp(1.0, exponent - (digits - 1));
    const double rounded = std::nearbyint(value / unit) * unit;
    const double magnitude = std::abs(rounded);
    return static_cast<T>(magnitude > 65504.0 ? std::copysign(std::numeric_limits<double>::infinity(), value)
                                              : std::copysign(magnitude, value));
}

}  // namespace scalars

GLOAM_FUNCTION(SmoothStep, smoothstep)
GLOAM_FUNCTION(QuantizeToHalf, quantize_to_half)
GLOAM_OPERATOR(Add, +)
GLOAM_OPERATOR(Subtract, -)
GLOAM_OPERATOR(Multiply, *)
GLOAM_OPERATOR(Divide, /)
GLOAM_OPERATOR(Less, <)
GLOAM_OPERATOR(LessEqual, <=)
GLOAM_OPERATOR(Equal, ==)
#undef GLOAM_FUNCTION
#undef GLOAM_OF_REALS
#undef GLOAM_BY_DOUBLE
#undef GLOAM_OPERATOR

template <std::integral I>
struct ToInteger {
    template <class N>
    I operator()(const N& x) const {
        if constexpr (std::is_floating_point_v<N>) {
            return scalars::to_integer<I>(x);
        } else {
            return numeric::to_integer<I>(x);
        }
    }
};
struct Negate {
    template <class N>
    N operator()(const N& x) const {
        return -x;
    }
};
// A comparison with its operands exchanged (a > b from a < b), or with its result negated, which is true for
// NaN.
template <class F>
struct Exchanged {
    template <class N>
    bool operator()(const N& x, const N& y) const {
        return F{}(y, x);
    }
};
template <class F>
struct Reversed {
    template <class N>
    bool operator()(const N& x, const N& y) const {
        return !F{}(x, y);
    }
};
// True if either comparison is. For example, "not equal and not NaN" is "less or greater".
template <class F, class G>
struct Either {
    template <class N>
    bool operator()(const N& x, const N& y) const {
        return F{}(x, y) || G{}(x, y);
    }
};

}  // namespace gloam::interpreter::internal
