// SPDX-License-Identifier: MIT
#pragma once

#include "interpreter/internal/scalars.hpp"
#include "interpreter/internal/state.hpp"

#include "interpreter/internal/opcodes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <type_traits>

// Integers and bools, two's complement. SPIR-V and Vulkan leave some results undefined: division by zero, a
// remainder of negative numbers, a shift by 32 and others. They are undefined values; float has one fixed
// result for each.
namespace gloam::interpreter::internal {

inline constexpr Word word_bits = 32;
inline constexpr Word magnitude_mask = 0x7fffffffU;  // of a float: all but its sign

[[nodiscard]] constexpr std::int32_t as_int(Word x) {
    return static_cast<std::int32_t>(x);
}
[[nodiscard]] constexpr Word mask_of(Word width) {
    return width >= word_bits ? ~Word{0} : (Word{1} << width) - 1U;
}
[[nodiscard]] constexpr Word signed_quotient(Word x, Word y) {
    if (y == 0) return ~Word{0};
    return y == ~Word{0} ? Word{0} - x : static_cast<Word>(as_int(x) / as_int(y));
}
[[nodiscard]] constexpr Word signed_remainder(Word x, Word y) {
    if (y == 0) return ~Word{0};
    return y == ~Word{0} ? Word{0} : static_cast<Word>(as_int(x) % as_int(y));
}
// The remainder with the sign of the divisor.
[[nodiscard]] constexpr Word signed_modulo(Word x, Word y) {
    const Word rest = signed_remainder(x, y);
    return y != 0 && rest != 0 && (as_int(rest) < 0) != (as_int(y) < 0) ? rest + y : rest;
}
// The operands for which the results of these operations are defined.
[[nodiscard]] constexpr bool divides(Word, Word y) {
    return y != 0;
}
[[nodiscard]] constexpr bool signed_divides(Word x, Word y) {
    return y != 0 && !(y == ~Word{0} && x == Word{1} << (word_bits - 1U));
}
[[nodiscard]] constexpr bool signed_leaves(Word x, Word y) {
    return y != 0 && as_int(x) >= 0 && as_int(y) >= 0;
}
[[nodiscard]] constexpr bool shifts(Word, Word distance) {
    return distance < word_bits;
}
[[nodiscard]] constexpr bool is_field(Word offset, Word width) {
    return offset <= word_bits && width <= word_bits - offset;
}
[[nodiscard]] constexpr Word reversed(Word x) {
    Word result = 0;
    for (Word bit = 0; bit < word_bits; ++bit) result |= (x >> bit & 1U) << (word_bits - 1U - bit);
    return result;
}
[[nodiscard]] constexpr Word extracted(Word x, Word offset, Word width, bool is_signed) {
    if (width == 0 || offset >= word_bits) return 0;
    const Word field = x >> offset & mask_of(width);
    const bool negative = is_signed && width < word_bits && (field >> (width - 1U) & 1U) != 0;
    return negative ? field | ~mask_of(width) : field;
}
[[nodiscard]] constexpr Word inserted(Word base, Word field, Word offset, Word width) {
    if (width == 0 || offset >= word_bits) return base;
    const Word mask = mask_of(width) << offset;
    return (base & ~mask) | (field << offset & mask);
}
// Position of the most significant set bit; -1 for none.
[[nodiscard]] constexpr Word highest_bit(Word x) {
    return word_bits - 1U - static_cast<Word>(std::countl_zero(x));
}

// What an atomic operation leaves.
[[nodiscard]] inline Word exchanged(std::uint32_t opcode, Word before, Word operand, Word expected) {
    switch (opcode) {
        case SpvOpAtomicIIncrement:
            return before + 1U;
        case SpvOpAtomicIDecrement:
            return before - 1U;
        case SpvOpAtomicIAdd:
            return before + operand;
        case SpvOpAtomicISub:
            return before - operand;
        case SpvOpAtomicSMin:
            return as_int(operand) < as_int(before) ? operand : before;
        case SpvOpAtomicUMin:
            return std::min(before, operand);
        case SpvOpAtomicSMax:
            return as_int(operand) > as_int(before) ? operand : before;
        case SpvOpAtomicUMax:
            return std::max(before, operand);
        case SpvOpAtomicAnd:
            return before & operand;
        case SpvOpAtomicOr:
            return before | operand;
        case SpvOpAtomicXor:
            return before ^ operand;
        case SpvOpAtomicCompareExchange:
            return before == expected ? operand : before;
        default:
            return operand;  // store and exchange
    }
}

template <class N, auto F>
void on_one(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) s.set(i, i.result + k, static_cast<Word>(F(s.bits(i.a + k))));
}
template <class N, auto F>
void on_two(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.set(i, i.result + k, static_cast<Word>(F(s.bits(i.a + k), s.bits(i.b + k))));
}
// Whether a comparison of words holds for a float of which the bounds are known: the words of positive
// floats, of negative ones and of NaNs each have an order.
template <class F>
[[nodiscard]] bool holds_for(const numeric::Interval& x, const F& holds) {
    constexpr Word sign = ~magnitude_mask;
    constexpr Word first_nan = exponent_mask + 1U;
    const auto word = [](double end) { return std::bit_cast<Word>(static_cast<float>(std::max(end, 0.0))); };
    std::array<bool, 2> seen{};
    const auto see = [&](Word low, Word high) { seen[holds(low)] = seen[holds(high)] = true; };
    if (x.high() >= 0.0) see(word(x.low()), word(x.high()));
    if (x.low() <= 0.0) see(sign | word(-x.high()), sign | word(-x.low()));
    if (x.may_be_nan()) see(first_nan, magnitude_mask), see(sign | first_nan, ~Word{0});
    return seen[0] && seen[1] ? numeric::Paths::choose(2) == 1 : seen[1];
}

// With a bool as its result.
template <class N, auto F>
void compare(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Value<N>& x = s.slots[i.a + k];
        const Value<N>& y = s.slots[i.b + k];
        if constexpr (has_bounds<N>) {
            const bool open = x.is_number() != y.is_number() && !x.is_undefined() && !y.is_undefined();
            const auto number = open ? settled((x.is_number() ? x : y).number()) : numeric::Interval();
            if (open && !number.bounds().is_point()) {
                const Word word = (x.is_number() ? y : x).bits();
                s.set(i, i.result + k, holds_for(number, [&](Word of_number) {
                          return x.is_number() ? bool{F(of_number, word)} : bool{F(word, of_number)};
                      }));
                continue;
            }
        }
        s.set(i, i.result + k, bool{F(s.bits(i.a + k), s.bits(i.b + k))});
    }
}
// An operation with a result where `defined` says so.
template <class N, auto F, auto Defined>
void on_two_if(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Word x = s.bits(i.a + k);
        const Word y = s.bits(i.b + k);
        s.set_if(Defined(x, y), i, i.result + k, static_cast<Word>(F(x, y)));
    }
}
// clamp(), undefined where the lower end is above the upper one.
template <class N, class Integer>
void clamp_integer(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const auto x = static_cast<Integer>(s.bits(i.a + k));
        const auto low = static_cast<Integer>(s.bits(i.b + k));
        const auto high = static_cast<Integer>(s.bits(i.c + k));
        s.set_if(low <= high, i, i.result + k, static_cast<Word>(std::min(std::max(x, low), high)));
    }
}

// Offset and width are the same for all components.
template <class N, bool Signed>
void bit_field_extract(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Word offset = s.bits(i.b);
        const Word width = s.bits(i.c);
        const Word field = extracted(s.bits(i.a + k), offset, width, Signed);
        s.set_if(is_field(offset, width), i, i.result + k, field);
    }
}
template <class N>
void bit_field_insert(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Word offset = s.bits(i.c);
        const Word width = s.bits(i.extra);
        const Word word = inserted(s.bits(i.a + k), s.bits(i.b + k), offset, width);
        s.set_if(is_field(offset, width), i, i.result + k, word);
    }
}

// Two results: low words, then high words (or carries).
template <class N, auto F>
void to_two(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const std::uint64_t both = F(s.bits(i.a + k), s.bits(i.b + k));
        s.set(i, i.result + k, static_cast<Word>(both));
        s.set(i, i.result + i.count + k, static_cast<Word>(both >> word_bits));
    }
}

// The sign bit of a float can be known when its other bits are not.
template <class N>
void shift_right(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Word distance = s.bits(i.b + k);
        const Value<N>& x = s.slots[i.a + k];
        if (distance == word_bits - 1U && x.is_number()) {
            s.set(i, i.result + k, sign_bit(x.number()));
        } else {
            const Word word = s.bits(i.a + k);
            s.set_if(distance < word_bits, i, i.result + k, distance < word_bits ? word >> distance : 0U);
        }
    }
}

// Whether a float is finite, and its magnitude, can be known when its bits are not.
template <class N>
void bitwise_and(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Value<N>& x = s.slots[i.a + k];
        const Value<N>& y = s.slots[i.b + k];
        if (x.is_number() != y.is_number() && !x.is_undefined() && !y.is_undefined()) {
            const Value<N>& number = x.is_number() ? x : y;
            const Word mask = (x.is_number() ? y : x).bits();
            std::optional<N> field;
            if (mask == exponent_mask) field = exponent_field(number.number());
            if (mask == magnitude_mask && has_bounds<N>) field = apply(Abs{}, number.number());
            if (field) {
                s.slots[i.result + k] = Value<N>::of(*field);
                continue;
            }
        }
        s.set(i, i.result + k, Word{s.bits(i.a + k) & s.bits(i.b + k)});
    }
}

// Whether words are equal: a float has the bits of +infinity when it is +infinity.
template <class N, bool IfEqual>
void compare_words(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const Value<N>& x = s.slots[i.a + k];
        const Value<N>& y = s.slots[i.b + k];
        const bool touched = s.touch(i.a + k) || s.touch(i.b + k);
        const bool by_number =
            !touched && x.is_number() != y.is_number() && (x.is_number() ? y : x).bits() == exponent_mask;
        // Bits are compared as they are, whatever a driver assumes of infinity.
        const N& number = x.is_number() ? x.number() : y.number();
        const bool equal = by_number ? apply(IsInfinite{}, number) && sign_bit(number) == 0
                                     : s.bits(i.a + k) == s.bits(i.b + k);
        s.set(i, i.result + k, equal == IfEqual);
    }
}

template <class N, bool All>
void reduce(State<N>& s, const Instruction& i) {
    bool result = All;
    for (std::uint32_t k = 0; k < i.count; ++k)
        result = All ? result && s.bits(i.a + k) != 0 : result || s.bits(i.a + k) != 0;
    s.set(i, i.result, result);
}

}  // namespace gloam::interpreter::internal
