// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"
#include "numeric/rearranged.hpp"

// The number types on which a module can be run:
//   float                 every operation rounded correctly, to nearest; nothing flushed. The result is the
//   same
//                         on every machine, except for functions that IEEE 754 does not round (sin, exp, ...)
//   double                represents the real numbers
//   numeric::Interval     all that Vulkan's precision rules permit, for modules that forbid rearrangement
//   numeric::Rearranged   the same for modules that let a driver contract and rearrange
//   Explained             all of them at once for one path, with the error that each operation adds
// Operations of float16 are rounded to it, on intervals by its rules.
namespace gloam::interpreter {

// float, double and the permitted results side by side, on the path that float takes.
struct Explained {
    double value = 0.0;  // of the operation's format
    double exact = 0.0;
    double local =
        0.0;  // by how much the last operation missed its own exact result, on the operands that it had
    numeric::Interval permitted = numeric::Interval::within(0.0, 0.0);
};

// What a number is permitted to be; of float and double nothing is known.
[[nodiscard]] inline const numeric::Interval& permitted_of(const numeric::Interval& x) {
    return x;
}
[[nodiscard]] inline numeric::Interval permitted_of(const numeric::Rearranged& x) {
    return x.interval();
}
[[nodiscard]] inline const numeric::Interval& permitted_of(const Explained& x) {
    return x.permitted;
}

// Whether the numbers stand for all that is permitted.
template <class N>
inline constexpr bool has_bounds =
    std::is_same_v<N, numeric::Interval> || std::is_same_v<N, numeric::Rearranged>;

// The number with f(what it is permitted to be, what others are) instead.
template <class F, class N, class... More>
[[nodiscard]] N with_permitted(const F& f, const N& x, const More&... more) {
    if constexpr (std::is_floating_point_v<N>) {
        return x;
    } else if constexpr (has_bounds<N>) {
        return N(f(permitted_of(x), permitted_of(more)...));
    } else {
        N result = x;
        result.permitted = f(x.permitted, permitted_of(more)...);
        return result;
    }
}

template <class Number>
[[nodiscard]] Number number_from_bits(std::uint32_t bits) {
    const auto value = std::bit_cast<float>(bits);
    if constexpr (std::is_floating_point_v<Number>) {
        return value;
    } else if constexpr (has_bounds<Number>) {
        return Number(numeric::Interval::input(value));
    } else {
        return {.value = value, .exact = value, .local = 0.0, .permitted = numeric::Interval::input(value)};
    }
}

template <class Number>
[[nodiscard]] Number undefined_number() {
    return with_permitted([](const auto&...) { return numeric::Interval::anything(); }, Number{});
}
template <class Number>
[[nodiscard]] std::uint32_t undefined_bits() {
    if (has_bounds<Number>) throw numeric::Paths::Undetermined{};
    return 0;
}

// Whether two numbers are one: on every type they agree, and so do their bounds.
[[nodiscard]] inline bool is_one_number(const Explained& x, const Explained& y) {
    return x.value == y.value && x.exact == y.exact && x.permitted.bounds() == y.permitted.bounds();
}

// The sign bit: 1 below zero and for -0. On intervals both values are explored if both are possible.
[[nodiscard]] std::uint32_t sign_of(const numeric::Interval& x);
template <class Number>
[[nodiscard]] std::uint32_t sign_bit(const Number& x) {
    if constexpr (has_bounds<Number>) {
        return sign_of(permitted_of(x));
    } else if constexpr (std::is_floating_point_v<Number>) {
        return std::signbit(x) ? 1U : 0U;
    } else {
        return std::signbit(x.value) ? 1U : 0U;
    }
}

// The bits of the exponent, 0x7f800000, as a number: 0 or a power of two if x is finite, otherwise +infinity.
// On intervals both are explored if both are possible. nullopt for a type whose numbers have known bits.
inline constexpr std::uint32_t exponent_mask = 0x7f800000U;
[[nodiscard]] numeric::Interval exponent_of(const numeric::Interval& x);
template <class Number>
[[nodiscard]] std::optional<Number> exponent_field(const Number& x) {
    if constexpr (has_bounds<Number>) {
        return Number(exponent_of(permitted_of(x)));
    } else {
        return std::nullopt;
    }
}

template <class Number>
[[nodiscard]] std::uint32_t bits_from_number(const Number& x) {
    if constexpr (has_bounds<Number>) {
        return numeric::to_bits(permitted_of(x));
    } else if constexpr (std::is_floating_point_v<Number>) {
        return std::bit_cast<std::uint32_t>(static_cast<float>(x));
    } else {
        return bits_from_number(x.value);
    }
}

}  // namespace gloam::interpreter
