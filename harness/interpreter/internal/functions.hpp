// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/scalars.hpp"
#include "numeric/interval.hpp"

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
GLOAM_UNARY(ToInt, to_int)
GLOAM_UNARY(ToUint, to_uint)
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

struct Identity {
    template <class N>
    N operator()(const N& x) const {
        return x;
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
