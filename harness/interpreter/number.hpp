// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "numeric/interval.hpp"
#include "numeric/rearranged.hpp"

// The number types that a module can be run on:
//   float                 every operation rounded correctly, to nearest; nothing flushed. The same result on
//                         every machine, but for the functions that IEEE 754 does not round (sin, exp, ...)
//   double                stands for the real numbers
//   numeric::Interval     all that Vulkan's precision rules permit, for modules that forbid rearrangement
//   numeric::Rearranged   the same where the module lets a driver contract and rearrange
//   Explained             all of it at once for one path, with the error that each operation adds
namespace gloam::interpreter {

// float, double and the permitted results side by side, on the path that float takes.
struct Explained {
    float value = 0.0F;
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

// 1 below zero and for -0. On intervals both are explored where both are in reach.
[[nodiscard]] std::uint32_t sign_bit(const numeric::Interval& x);
[[nodiscard]] std::uint32_t sign_bit(const numeric::Rearranged& x);
[[nodiscard]] inline std::uint32_t sign_bit(double x) {
    return std::signbit(x) ? 1U : 0U;
}
[[nodiscard]] inline std::uint32_t sign_bit(const Explained& x) {
    return std::signbit(x.value) ? 1U : 0U;
}

[[nodiscard]] std::uint32_t bits_from_number(double x);
[[nodiscard]] std::uint32_t bits_from_number(const numeric::Interval& x);
[[nodiscard]] std::uint32_t bits_from_number(const numeric::Rearranged& x);
[[nodiscard]] std::uint32_t bits_from_number(const Explained& x);

}  // namespace gloam::interpreter
