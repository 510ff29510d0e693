// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// The high word of a product of 64 bits; the constant is frac(10 / (2 pi)) 2^64.
template <class T = double>
unsigned gloam_hash_turn(unsigned h) {
    return static_cast<unsigned>((h * 0x976FC893C3AA34E9ULL) >> 32U);
}

namespace detail {

// The part of a turn that 10 h radians leave, by halves of h so that double keeps eleven digits of it: the
// constants are the fractional parts of 10 / (2 pi) and of 65536 times that.
template <class T>
T exact_hash_turn(unsigned h) {
    const T low = T(static_cast<double>(h % 65536U)) * T(0.59154943091895335769);
    const T high = T(static_cast<double>(h / 65536U)) * T(0.78350470452724949566);
    return fract(low + high);
}

}  // namespace detail

template <class T = double>
T gloam_hash_rotation(glm::ivec2 pixel) {
    const auto x = static_cast<unsigned>(pixel.x);
    const auto y = static_cast<unsigned>(pixel.y);
    return T(2) * pi<T>() * detail::exact_hash_turn<T>((3U * x) ^ (y + x * y));
}

}  // namespace gloam::reference
