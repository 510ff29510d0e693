// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// frac(10 h / (2 pi)) in units of 2^-32: the constant is frac(10 / (2 pi)) 2^64.
inline unsigned gloam_hash_turn(unsigned h) {
    return static_cast<unsigned>((h * 0x976FC893C3AA34E9ULL) >> 32U);
}

// The angle 10 h in radians, where h = (3 x) ^ (y + x y) in 32 bits, less whole turns: 2 pi as the sum of two
// doubles, so that 7e9 turns leave 1e-15 of error.
inline double gloam_hash_rotation(glm::ivec2 pixel) {
    const glm::uvec2 p(pixel);
    const double angle = 10.0 * ((3U * p.x) ^ (p.y + p.x * p.y));
    constexpr double two_pi = 2.0 * std::numbers::pi;
    constexpr double two_pi_rest = 2.4492935982947064e-16;
    const double turns = std::floor(angle / two_pi);
    const double within = std::fma(-turns, two_pi_rest, std::fma(-turns, two_pi, angle));
    return within < 0.0 ? within + two_pi : within;
}

}  // namespace gloam::reference
