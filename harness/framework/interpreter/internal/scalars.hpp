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

template <Real T>
T atan(T y, T x) {
    return static_cast<T>(std::atan2(static_cast<double>(y), static_cast<double>(x)));
}
template <Real T>
T pow(T x, T y) {
    return static_cast<T>(std::pow(static_cast<double>(x), static_cast<double>(y)));
}
template <Real T>
T abs(T x) {
    return std::abs(x);
}
template <Real T>
T sign(T x) {
    return x > T(0) ? T(1) : (x < T(0) ? T(-1) : x);
}
template <Real T>
T min(T a, T b) {
    return b < a || std::isnan(a) ? b : a;
}
template <Real T>
T max(T a, T b) {
    return a < b || std::isnan(a) ? b : a;
}
template <Real T>
T clamp(T x, T low, T high) {
    return scalars::min(scalars::max(x, low), high);
}
template <Real T>
T step(T edge, T x) {
    return x < edge ? T(0) : T(1);
}
template <Real T>
T fract(T x) {
    return x - std::floor(x);
}
template <Real T>
T mod(T x, T y) {
    return x - y * std::floor(x / y);
}
template <Real T>
T remainder(T x, T y) {
    return x - y * std::trunc(x / y);
}
template <Real T>
T mix(T a, T b, T t) {
    return a * (T(1) - t) + b * t;
}
template <Real T>
T smoothstep(T edge0, T edge1, T x) {
    const T t = scalars::clamp((x - edge0) / (edge1 - edge0), T(0), T(1));
    return t * t * (T(3) - T(2) * t);
}
template <Real T>
T ldexp(T x, int exponent) {
    return std::ldexp(x, exponent);
}
template <Real T>
T fma(T a, T b, T c) {
    return std::fma(a, b, c);
}
template <Real T>
bool is_nan(T x) {
    return std::isnan(x);
}
template <Real T>
bool is_infinite(T x) {
    return std::isinf(x);
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

#define GLOAM_UNARY(Name, function)         \
    struct Name {                           \
        template <class N>                  \
        auto operator()(const N& x) const { \
            using namespace scalars;        \
            return function(x);             \
        }                                   \
    };
#define GLOAM_BINARY(Name, function)                    \
    struct Name {                                       \
        template <class N>                              \
        auto operator()(const N& x, const N& y) const { \
            using namespace scalars;                    \
            return function(x, y);                      \
        }                                               \
    };
#define GLOAM_TERNARY(Name, function)                               \
    struct Name {                                                   \
        template <class N>                                          \
        auto operator()(const N& x, const N& y, const N& z) const { \
            using namespace scalars;                                \
            return function(x, y, z);                               \
        }                                                           \
    };

GLOAM_UNARY(Sqrt, sqrt)
GLOAM_UNARY(InverseSqrt, inversesqrt)
GLOAM_UNARY(Sin, sin)
GLOAM_UNARY(Cos, cos)
GLOAM_UNARY(Tan, tan)
GLOAM_UNARY(Asin, asin)
GLOAM_UNARY(Acos, acos)
GLOAM_UNARY(Atan, atan)
GLOAM_UNARY(Sinh, sinh)
GLOAM_UNARY(Cosh, cosh)
GLOAM_UNARY(Tanh, tanh)
GLOAM_UNARY(Asinh, asinh)
GLOAM_UNARY(Acosh, acosh)
GLOAM_UNARY(Atanh, atanh)
GLOAM_UNARY(Exp, exp)
GLOAM_UNARY(Exp2, exp2)
GLOAM_UNARY(Log, log)
GLOAM_UNARY(Log2, log2)
GLOAM_UNARY(Floor, floor)
GLOAM_UNARY(Ceil, ceil)
GLOAM_UNARY(Trunc, trunc)
GLOAM_UNARY(Round, round)
GLOAM_UNARY(RoundEven, round_even)
GLOAM_UNARY(Fract, fract)
GLOAM_UNARY(Radians, radians)
GLOAM_UNARY(Degrees, degrees)
GLOAM_UNARY(Abs, abs)
GLOAM_UNARY(Sign, sign)
GLOAM_UNARY(QuantizeToHalf, quantize_to_half)
GLOAM_UNARY(IsNan, is_nan)
GLOAM_UNARY(IsInfinite, is_infinite)
GLOAM_BINARY(Atan2, atan)
GLOAM_BINARY(Pow, pow)
GLOAM_BINARY(Min, min)
GLOAM_BINARY(Max, max)
GLOAM_BINARY(StepAt, step)
GLOAM_BINARY(Mod, mod)
GLOAM_BINARY(Remainder, remainder)
GLOAM_TERNARY(Clamp, clamp)
GLOAM_TERNARY(SmoothStep, smoothstep)
GLOAM_TERNARY(Mix, mix)
GLOAM_TERNARY(Fma, fma)

#undef GLOAM_UNARY
#undef GLOAM_BINARY
#undef GLOAM_TERNARY

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
struct Add {
    template <class N>
    N operator()(const N& x, const N& y) const {
        return x + y;
    }
};
struct Subtract {
    template <class N>
    N operator()(const N& x, const N& y) const {
        return x - y;
    }
};
struct Multiply {
    template <class N>
    N operator()(const N& x, const N& y) const {
        return x * y;
    }
};
struct Divide {
    template <class N>
    N operator()(const N& x, const N& y) const {
        return x / y;
    }
};
struct Less {
    template <class N>
    bool operator()(const N& x, const N& y) const {
        return x < y;
    }
};
struct LessEqual {
    template <class N>
    bool operator()(const N& x, const N& y) const {
        return x <= y;
    }
};
struct Equal {
    template <class N>
    bool operator()(const N& x, const N& y) const {
        return x == y;
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
