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
// template serves every number type. A float result is computed in double and rounded once.
namespace gloam::interpreter::internal::scalars {

template <class T>
concept Real = std::same_as<T, float> || std::same_as<T, double>;

#define GLOAM_BY_DOUBLE(name, expression)             \
    template <Real T>                                 \
    T name(T argument) {                              \
        const auto x = static_cast<double>(argument); \
        return static_cast<T>(expression);            \
    }
GLOAM_BY_DOUBLE(sqrt, std::sqrt(x))
GLOAM_BY_DOUBLE(inversesqrt, 1.0 / std::sqrt(x))
GLOAM_BY_DOUBLE(sin, std::sin(x))
GLOAM_BY_DOUBLE(cos, std::cos(x))
GLOAM_BY_DOUBLE(tan, std::tan(x))
GLOAM_BY_DOUBLE(asin, std::asin(x))
GLOAM_BY_DOUBLE(acos, std::acos(x))
GLOAM_BY_DOUBLE(atan, std::atan(x))
GLOAM_BY_DOUBLE(sinh, std::sinh(x))
GLOAM_BY_DOUBLE(cosh, std::cosh(x))
GLOAM_BY_DOUBLE(tanh, std::tanh(x))
GLOAM_BY_DOUBLE(asinh, std::asinh(x))
GLOAM_BY_DOUBLE(acosh, std::acosh(x))
GLOAM_BY_DOUBLE(atanh, std::atanh(x))
GLOAM_BY_DOUBLE(exp, std::exp(x))
GLOAM_BY_DOUBLE(exp2, std::exp2(x))
GLOAM_BY_DOUBLE(log, std::log(x))
GLOAM_BY_DOUBLE(log2, std::log2(x))
GLOAM_BY_DOUBLE(floor, std::floor(x))
GLOAM_BY_DOUBLE(ceil, std::ceil(x))
GLOAM_BY_DOUBLE(trunc, std::trunc(x))
GLOAM_BY_DOUBLE(round, std::round(x))
GLOAM_BY_DOUBLE(round_even, std::nearbyint(x))
GLOAM_BY_DOUBLE(radians, x*(std::numbers::pi / 180.0))
GLOAM_BY_DOUBLE(degrees, x * (180.0 / std::numbers::pi))
#undef GLOAM_BY_DOUBLE

#define GLOAM_OF_REALS(Result, name, operands, expression) \
    template <Real T>                                      \
    Result name operands {                                 \
        return expression;                                 \
    }
GLOAM_OF_REALS(T, atan, (T y, T x),
               static_cast<T>(std::atan2(static_cast<double>(y), static_cast<double>(x))))
GLOAM_OF_REALS(T, pow, (T x, T y), static_cast<T>(std::pow(static_cast<double>(x), static_cast<double>(y))))
GLOAM_OF_REALS(T, abs, (T x), std::abs(x))
GLOAM_OF_REALS(T, sign, (T x), x > T(0) ? T(1) : (x < T(0) ? T(-1) : x))
GLOAM_OF_REALS(T, min, (T a, T b), b < a || std::isnan(a) ? b : a)
GLOAM_OF_REALS(T, max, (T a, T b), a < b || std::isnan(a) ? b : a)
GLOAM_OF_REALS(T, clamp, (T x, T low, T high), scalars::min(scalars::max(x, low), high))
GLOAM_OF_REALS(T, step, (T edge, T x), x < edge ? T(0) : T(1))
GLOAM_OF_REALS(T, fract, (T x), x - std::floor(x))
GLOAM_OF_REALS(T, mod, (T x, T y), x - y * std::floor(x / y))
GLOAM_OF_REALS(T, remainder, (T x, T y), x - y * std::trunc(x / y))
GLOAM_OF_REALS(T, mix, (T a, T b, T t), a*(T(1) - t) + b * t)
GLOAM_OF_REALS(T, ldexp, (T x, int exponent), std::ldexp(x, exponent))
GLOAM_OF_REALS(T, fma, (T a, T b, T c), std::fma(a, b, c))
GLOAM_OF_REALS(bool, is_nan, (T x), std::isnan(x))
GLOAM_OF_REALS(bool, is_infinite, (T x), std::isinf(x))
#undef GLOAM_OF_REALS

template <Real T>
T smoothstep(T edge0, T edge1, T x) {
    const T t = scalars::clamp((x - edge0) / (edge1 - edge0), T(0), T(1));
    return t * t * (T(3) - T(2) * t);
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

}  // namespace gloam::interpreter::internal::scalars

// The operations as function objects, each a template over the number type: float, double or
// numeric::Interval.
namespace gloam::interpreter::internal {

#define GLOAM_FUNCTION(Name, function)         \
    struct Name {                              \
        template <class... N>                  \
        auto operator()(const N&... x) const { \
            using namespace scalars;           \
            return function(x...);             \
        }                                      \
    };
#define GLOAM_OPERATOR(Name, symbol)                    \
    struct Name {                                       \
        template <class N>                              \
        auto operator()(const N& x, const N& y) const { \
            return x symbol y;                          \
        }                                               \
    };

GLOAM_FUNCTION(Sqrt, sqrt)
GLOAM_FUNCTION(InverseSqrt, inversesqrt)
GLOAM_FUNCTION(Sin, sin)
GLOAM_FUNCTION(Cos, cos)
GLOAM_FUNCTION(Tan, tan)
GLOAM_FUNCTION(Asin, asin)
GLOAM_FUNCTION(Acos, acos)
GLOAM_FUNCTION(Atan, atan)
GLOAM_FUNCTION(Sinh, sinh)
GLOAM_FUNCTION(Cosh, cosh)
GLOAM_FUNCTION(Tanh, tanh)
GLOAM_FUNCTION(Asinh, asinh)
GLOAM_FUNCTION(Acosh, acosh)
GLOAM_FUNCTION(Atanh, atanh)
GLOAM_FUNCTION(Exp, exp)
GLOAM_FUNCTION(Exp2, exp2)
GLOAM_FUNCTION(Log, log)
GLOAM_FUNCTION(Log2, log2)
GLOAM_FUNCTION(Floor, floor)
GLOAM_FUNCTION(Ceil, ceil)
GLOAM_FUNCTION(Trunc, trunc)
GLOAM_FUNCTION(Round, round)
GLOAM_FUNCTION(RoundEven, round_even)
GLOAM_FUNCTION(Fract, fract)
GLOAM_FUNCTION(Radians, radians)
GLOAM_FUNCTION(Degrees, degrees)
GLOAM_FUNCTION(Abs, abs)
GLOAM_FUNCTION(Sign, sign)
GLOAM_FUNCTION(QuantizeToHalf, quantize_to_half)
GLOAM_FUNCTION(IsNan, is_nan)
GLOAM_FUNCTION(IsInfinite, is_infinite)
GLOAM_FUNCTION(Atan2, atan)
GLOAM_FUNCTION(Pow, pow)
GLOAM_FUNCTION(Min, min)
GLOAM_FUNCTION(Max, max)
GLOAM_FUNCTION(StepAt, step)
GLOAM_FUNCTION(Mod, mod)
GLOAM_FUNCTION(Remainder, remainder)
GLOAM_FUNCTION(Clamp, clamp)
GLOAM_FUNCTION(SmoothStep, smoothstep)
GLOAM_FUNCTION(Mix, mix)
GLOAM_FUNCTION(Fma, fma)

GLOAM_OPERATOR(Add, +)
GLOAM_OPERATOR(Subtract, -)
GLOAM_OPERATOR(Multiply, *)
GLOAM_OPERATOR(Divide, /)
GLOAM_OPERATOR(Less, <)
GLOAM_OPERATOR(LessEqual, <=)
GLOAM_OPERATOR(Equal, ==)
#undef GLOAM_FUNCTION
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
