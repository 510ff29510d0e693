// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/opcodes.hpp"

#include <algorithm>
#include <cmath>

#include "interpreter/internal/scalars.hpp"
#include "interpreter/internal/state.hpp"

// Operations on floats, component by component.
namespace gloam::interpreter::internal {

// Whether SignedZeroInfNanPreserve binds an operation in each of its wordings, from Vulkan 1.1.95 on. Of the
// division, which is listed since 1.3.296, the older ones say in a sentence what a zero gives.
[[nodiscard]] constexpr bool keeps_specials(std::uint16_t opcode) {
    return opcode == SpvOpFConvert || opcode == SpvOpFNegate || opcode == SpvOpFAdd || opcode == SpvOpFSub ||
           opcode == SpvOpFMul || opcode == SpvOpFDiv;
}

// The result of an operation: anything if an operand is a NaN or an infinity that it need not keep.
template <class N, class... Operands>
[[nodiscard]] N assumed(const Instruction& i, const N& result, const Operands&... operands) {
    using numeric::Paths;
    if constexpr (has_bounds<N>) {
        const auto is_special = [](const auto& x) { return numeric::is_special(settled(x)); };
        const bool kept = Paths::specials() == Paths::Specials::kept ||
                          (Paths::specials() == Paths::Specials::listed && keeps_specials(i.op));
        if (!kept && (is_special(operands) || ...)) return undefined_number<N>();
    }
    return result;
}

template <class N, class F>
void unary(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        s.set(i, i.result + k, assumed(i, apply(F{}, x), x));
    }
}

template <class N, class F>
void binary(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const N y = s.number(i, i.b + k);
        s.set(i, i.result + k, assumed(i, apply(F{}, x, y), x, y));
    }
}

template <class N, class F>
void ternary(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const N y = s.number(i, i.b + k);
        const N z = s.number(i, i.c + k);
        s.set(i, i.result + k, assumed(i, apply(F{}, x, y, z), x, y, z));
    }
}

// An operation to which NoContraction applies. Without it, the operation may be rearranged together with
// others.
template <class F, class N, class... More>
[[nodiscard]] N contracted(const Instruction& i, const N& x, const More&... more) {
    if constexpr (std::is_same_v<N, numeric::Rearranged>) {
        if ((i.flags & flags::no_contraction) == 0) return F{}(x, more...);
    }
    return apply(F{}, x, more...);
}

// A square is not negative, though the product of two numbers with the same bounds may be.
[[nodiscard]] inline numeric::Interval not_negative(const numeric::Interval& x) {
    const numeric::Bounds& b = x.bounds();
    return b.empty() || b.low >= 0.0 ? x : numeric::Interval::within({0.0, std::max(b.high, 0.0), b.nan});
}
template <class N>
[[nodiscard]] N as_square(N product) {
    if constexpr (std::is_same_v<N, numeric::Interval>) {
        product = not_negative(product);
    } else if constexpr (std::is_same_v<N, Explained>) {
        product.permitted = not_negative(product.permitted);
    }
    return product;
}

// A product; on Explained a square is recognised by its operands, because a module loads a variable twice.
template <class N>
[[nodiscard]] N product(const Instruction& i, const N& x, const N& y) {
    if constexpr (std::is_same_v<N, Explained>) {
        if (is_one_number(x, y)) return as_square(contracted<Multiply>(i, x, y));
    }
    return contracted<Multiply>(i, x, y);
}

template <class N, class F>
void arithmetic(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const N y = s.number(i, i.b + k * i.stride);
        if constexpr (std::is_same_v<F, Multiply>) {
            s.set(i, i.result + k, assumed(i, product(i, x, y), x, y));
        } else {
            s.set(i, i.result + k, assumed(i, contracted<F>(i, x, y), x, y));
        }
    }
}

template <class N>
void negate(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        s.set(i, i.result + k, assumed(i, contracted<Negate>(i, x), x));
    }
}

template <class N>
[[nodiscard]] Handler<N> arithmetic_handler(std::uint16_t opcode) {
    switch (opcode) {
        case SpvOpFNegate:
            return negate<N>;
        case SpvOpFAdd:
            return arithmetic<N, Add>;
        case SpvOpFSub:
            return arithmetic<N, Subtract>;
        case SpvOpVectorTimesScalar:
        case SpvOpMatrixTimesScalar:
        case SpvOpFMul:
            return arithmetic<N, Multiply>;
        case SpvOpFDiv:
            return arithmetic<N, Divide>;
        case SpvOpFRem:
            return binary<N, Remainder>;
        case SpvOpFMod:
            return binary<N, Mod>;
        case SpvOpQuantizeToF16:
            return unary<N, QuantizeToHalf>;
        case SpvOpIsNan:
            return unary<N, IsNan>;
        case SpvOpIsInf:
            return unary<N, IsInfinite>;
        default:
            return nullptr;
    }
}

template <class N>
[[nodiscard]] Handler<N> comparison_handler(std::uint16_t opcode) {
    switch (opcode) {
        case SpvOpFOrdEqual:
            return binary<N, Equal>;
        case SpvOpFUnordNotEqual:
            return binary<N, Reversed<Equal>>;
        case SpvOpFOrdNotEqual:
            return binary<N, Either<Less, Exchanged<Less>>>;
        case SpvOpFUnordEqual:
            return binary<N, Reversed<Either<Less, Exchanged<Less>>>>;
        case SpvOpFOrdLessThan:
            return binary<N, Less>;
        case SpvOpFOrdGreaterThan:
            return binary<N, Exchanged<Less>>;
        case SpvOpFOrdLessThanEqual:
            return binary<N, LessEqual>;
        case SpvOpFOrdGreaterThanEqual:
            return binary<N, Exchanged<LessEqual>>;
        case SpvOpFUnordLessThan:
            return binary<N, Reversed<Exchanged<LessEqual>>>;
        case SpvOpFUnordGreaterThan:
            return binary<N, Reversed<LessEqual>>;
        case SpvOpFUnordLessThanEqual:
            return binary<N, Reversed<Exchanged<Less>>>;
        case SpvOpFUnordGreaterThanEqual:
            return binary<N, Reversed<Less>>;
        default:
            return nullptr;
    }
}

template <class N>
[[nodiscard]] Handler<N> elementary_handler(std::uint16_t function) {
    switch (function) {
        case GLSLstd450Round:
            return unary<N, Round>;
        case GLSLstd450RoundEven:
            return unary<N, RoundEven>;
        case GLSLstd450Trunc:
            return unary<N, Trunc>;
        case GLSLstd450FAbs:
            return unary<N, Abs>;
        case GLSLstd450FSign:
            return unary<N, Sign>;
        case GLSLstd450Floor:
            return unary<N, Floor>;
        case GLSLstd450Ceil:
            return unary<N, Ceil>;
        case GLSLstd450Fract:
            return unary<N, Fract>;
        case GLSLstd450Radians:
            return unary<N, Radians>;
        case GLSLstd450Degrees:
            return unary<N, Degrees>;
        case GLSLstd450Sin:
            return unary<N, Sin>;
        case GLSLstd450Cos:
            return unary<N, Cos>;
        case GLSLstd450Tan:
            return unary<N, Tan>;
        case GLSLstd450Asin:
            return unary<N, Asin>;
        case GLSLstd450Acos:
            return unary<N, Acos>;
        case GLSLstd450Atan:
            return unary<N, Atan>;
        case GLSLstd450Sinh:
            return unary<N, Sinh>;
        case GLSLstd450Cosh:
            return unary<N, Cosh>;
        case GLSLstd450Tanh:
            return unary<N, Tanh>;
        case GLSLstd450Asinh:
            return unary<N, Asinh>;
        case GLSLstd450Acosh:
            return unary<N, Acosh>;
        case GLSLstd450Atanh:
            return unary<N, Atanh>;
        case GLSLstd450Atan2:
            return binary<N, Atan2>;
        case GLSLstd450Pow:
            return binary<N, Pow>;
        case GLSLstd450Exp:
            return unary<N, Exp>;
        case GLSLstd450Log:
            return unary<N, Log>;
        case GLSLstd450Exp2:
            return unary<N, Exp2>;
        case GLSLstd450Log2:
            return unary<N, Log2>;
        case GLSLstd450Sqrt:
            return unary<N, Sqrt>;
        case GLSLstd450InverseSqrt:
            return unary<N, InverseSqrt>;
        case GLSLstd450NMin:
        case GLSLstd450FMin:
            return binary<N, Min>;
        case GLSLstd450NMax:
        case GLSLstd450FMax:
            return binary<N, Max>;
        case GLSLstd450NClamp:
        case GLSLstd450FClamp:
            return ternary<N, Clamp>;
        case GLSLstd450FMix:
            return ternary<N, Mix>;
        case GLSLstd450Fma:
            return ternary<N, Fma>;
        case GLSLstd450Step:
            return binary<N, StepAt>;
        case GLSLstd450SmoothStep:
            return ternary<N, SmoothStep>;
        default:
            return nullptr;
    }
}

}  // namespace gloam::interpreter::internal
