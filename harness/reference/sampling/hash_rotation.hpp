// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// frac(10 h / (2 pi)) in units of 2^-32: the constant is frac(10 / (2 pi)) 2^64.
inline unsigned gloam_hash_turn(unsigned h) {
    return static_cast<unsigned>((h * 0x976FC893C3AA34E9ULL) >> 32U);
}

// The angle 10 h in radians, where h = (3 x) ^ (y + x y) in 32 bits.
inline double gloam_hash_rotation(glm::ivec2 pixel) {
    const glm::uvec2 p(pixel);
    const long double angle = 10.0L * ((3U * p.x) ^ (p.y + p.x * p.y));
    return static_cast<double>(std::fmod(angle, 2.0L * std::numbers::pi_v<long double>));
}

}  // namespace gloam::reference
