// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "numeric/interval.hpp"
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

template <class Number>
[[nodiscard]] Number number_from_bits(std::uint32_t bits);
template <class Number>
[[nodiscard]] Number undefined_number();
template <class Number>
[[nodiscard]] std::uint32_t undefined_bits();

// Whether two numbers are one: on every type they agree, and so do their bounds.
[[nodiscard]] inline bool is_one_number(const Explained& x, const Explained& y) {
    return x.value == y.value && x.exact == y.exact && x.permitted.bounds() == y.permitted.bounds();
}

// The sign bit: 1 below zero and for -0. On intervals both values are explored if both are possible.
[[nodiscard]] std::uint32_t sign_bit(const numeric::Interval& x);
[[nodiscard]] std::uint32_t sign_bit(const numeric::Rearranged& x);
[[nodiscard]] inline std::uint32_t sign_bit(double x) {
    return std::signbit(x) ? 1U : 0U;
}
[[nodiscard]] inline std::uint32_t sign_bit(const Explained& x) {
    return std::signbit(x.value) ? 1U : 0U;
}

// The bits of the exponent, 0x7f800000, as a number: 0 or a power of two if x is finite, otherwise +infinity.
// On intervals both are explored if both are possible. nullopt for a type whose numbers have known bits.
inline constexpr std::uint32_t exponent_mask = 0x7f800000U;
template <class Number>
[[nodiscard]] std::optional<Number> exponent_field(const Number& x);

[[nodiscard]] std::uint32_t bits_from_number(double x);
[[nodiscard]] std::uint32_t bits_from_number(const numeric::Interval& x);
[[nodiscard]] std::uint32_t bits_from_number(const numeric::Rearranged& x);
[[nodiscard]] std::uint32_t bits_from_number(const Explained& x);

}  // namespace gloam::interpreter
