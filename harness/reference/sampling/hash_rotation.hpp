// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// The high word of a product of 64 bits; the constant is frac(10 / (2 pi)) 2^64.
template <class T = double>
unsigned gloam_hash_turn(unsigned h) {
    return static_cast<unsigned>((h * 0x976FC893C3AA34E9ULL) >> 32U);
}

template <class T = double>
T gloam_hash_rotation(glm::ivec2 pixel) {
    const auto x = static_cast<unsigned>(pixel.x);
    const auto y = static_cast<unsigned>(pixel.y);
    const unsigned h = (3U * x) ^ (y + x * y);
    if constexpr (exact_number<T>) {
        // By halves of h, so that double keeps eleven digits: the constants are the fractional parts of
        // 10 / (2 pi) and of 65536 times that.
        return T(2) * pi<T>() *
               fract(T(h % 65536U) * T(0.59154943091895335769) + T(h / 65536U) * T(0.78350470452724949566));
    }
    return min(T(gloam_hash_turn<T>(h)) * T(1.46291807926716e-9), T(6.283185005));
}

}  // namespace gloam::reference
