// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/opcodes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "interpreter/internal/scalars.hpp"
#include "interpreter/internal/state.hpp"

// Operations on floats, component by component.
namespace gloam::interpreter::internal {

// Whether SignedZeroInfNanPreserve binds an operation in each of its wordings, from Vulkan 1.1.95 on. Of the
// division, which is listed since 1.3.296, the older ones say in a sentence what a zero gives.
[[nodiscard]] constexpr bool keeps_specials(const Instruction& i) {
    if ((i.flags & flags::derivative) != 0) return false;
    return i.op == SpvOpFConvert || i.op == SpvOpFNegate || i.op == SpvOpFAdd || i.op == SpvOpFSub ||
           i.op == SpvOpFMul || i.op == SpvOpFDiv;
}

// The result of an operation: anything if an operand is a NaN or an infinity that it need not keep.
template <class N, class... Operands>
[[nodiscard]] N assumed(const Instruction& i, const N& result, const Operands&... operands) {
    using numeric::Paths;
    if constexpr (has_bounds<N>) {
        const auto is_special = [](const auto& x) { return numeric::is_special(settled(x)); };
        const bool kept = Paths::specials() == Paths::Specials::kept ||
                          (Paths::specials() == Paths::Specials::listed && keeps_specials(i));
        if (!kept && (is_special(operands) || ...)) return undefined_number<N>();
    }
    return result;
}

// The value of a number; NaN of an interval, whose operations tell by themselves what is undefined.
template <class N>
[[nodiscard]] double known_value(const N& x) {
    if constexpr (std::is_floating_point_v<N>) {
        return static_cast<double>(x);
    } else if constexpr (has_bounds<N>) {
        return std::numeric_limits<double>::quiet_NaN();
    } else {
        return x.value;
    }
}

// clamp(): undefined where the lower end is above the upper one.
template <class N>
void clamp_float(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        const N low = s.number(i, i.b + k);
        const N high = s.number(i, i.c + k);
        const N result = assumed(i, apply(Clamp{}, x, low, high), x, low, high);
        s.set_if(!(known_value(low) > known_value(high)), i, i.result + k, result);
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

// The operations to which NoContraction applies.
template <class F>
inline constexpr bool may_contract = std::is_same_v<F, Add> || std::is_same_v<F, Subtract> ||
                                     std::is_same_v<F, Divide> || std::is_same_v<F, Negate>;
template <class F, class N, class... More>
[[nodiscard]] auto result_of(const Instruction& i, const N& x, const More&... more) {
    if constexpr (std::is_same_v<F, Multiply>) {
        return product(i, x, more...);
    } else if constexpr (may_contract<F>) {
        return contracted<F>(i, x, more...);
    } else {
        return apply(F{}, x, more...);
    }
}

// An operation on these operands, component by component; the second may be one scalar for all.
template <class N, class F, auto... Operands>
void on_numbers(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const std::array<N, sizeof...(Operands)> all{
            s.number(i, i.*Operands + (Operands == &Instruction::b ? k * i.stride : k))...};
        const auto result = [&](const auto&... x) { return assumed(i, result_of<F>(i, x...), x...); };
        s.set(i, i.result + k, std::apply(result, all));
    }
}
template <class N, class F>
inline constexpr auto unary = on_numbers<N, F, &Instruction::a>;
template <class N, class F>
inline constexpr auto binary = on_numbers<N, F, &Instruction::a, &Instruction::b>;
template <class N, class F>
inline constexpr auto ternary = on_numbers<N, F, &Instruction::a, &Instruction::b, &Instruction::c>;

}  // namespace gloam::interpreter::internal
