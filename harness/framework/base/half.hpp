// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>

namespace gloam::base {

// value / 2^shift, rounded to nearest, ties to even.
[[nodiscard]] constexpr std::uint32_t shift_right_to_even(std::uint32_t value, std::uint32_t shift) {
    const std::uint32_t quotient = value >> shift;
    const std::uint32_t rest = value & ((1u << shift) - 1u);
    const std::uint32_t tie = 1u << (shift - 1u);
    return quotient + (rest > tie || (rest == tie && (quotient & 1u) != 0) ? 1u : 0u);
}

// float32 to binary16, to nearest even: 65520 and above become infinity, 2^-25 and below become zero. A NaN
// becomes a quiet NaN.
[[nodiscard]] constexpr std::uint16_t to_half(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t sign = bits >> 16 & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    std::uint32_t half = 0;
    if (magnitude > 0x7f800000u) {
        half = 0x7e00u | (magnitude >> 13 & 0x1ffu);
    } else if (magnitude >= 0x477ff000u) {
        half = 0x7c00u;
    } else if (magnitude >= 0x38800000u) {  // 2^-14: the smallest normal half
        half = shift_right_to_even(magnitude - 0x38000000u, 13);
    } else if (magnitude > 0x33000000u) {  // multiples of 2^-24
        half = shift_right_to_even((magnitude & 0x7fffffu) | 0x800000u, 126u - (magnitude >> 23));
    }
    return static_cast<std::uint16_t>(sign | half);
}

// binary16 to float32, exact.
[[nodiscard]] constexpr float from_half(std::uint16_t half) {
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t exponent = half >> 10 & 0x1fu;
    const std::uint32_t fraction = half & 0x3ffu;
    if (exponent == 0) {
        const auto magnitude = std::bit_cast<std::uint32_t>(static_cast<float>(fraction) * 0x1p-24f);
        return std::bit_cast<float>(sign | magnitude);
    }
    const std::uint32_t widened = exponent == 0x1fu ? 0xffu : exponent + 112u;
    return std::bit_cast<float>(sign | widened << 23 | fraction << 13);
}

}  // namespace gloam::base
