// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "reference/math.hpp"

namespace gloam::reference {

// The smallest exponent e >= 0 with which every component rounds to at most 255 when divided by 2^e.
inline unsigned gloam_displacement_to_code(const dvec3& displacement, double unit) {
    const dvec3 units = displacement / unit;
    const double sum = std::abs(units.x) + std::abs(units.y) + std::abs(units.z);
    if (!(sum <= 255.0 * 0x1p31)) return 31U << 27U | 255U << 18U | 255U << 9U | 255U;
    const double largest = std::max({std::abs(units.x), std::abs(units.y), std::abs(units.z)});
    int exponent = 0;
    while (std::ldexp(largest, -exponent) >= 255.5) ++exponent;
    const auto bits = [&](double component) {  // the two's complement
        return static_cast<unsigned>(static_cast<int>(std::round(std::ldexp(component, -exponent)))) % 512U;
    };
    return bits(units.x) | bits(units.y) << 9U | bits(units.z) << 18U |
           static_cast<unsigned>(exponent) << 27U;
}

inline dvec3 gloam_displacement_from_code(unsigned code, double unit) {
    const auto component = [&](unsigned first) {
        const int bits = static_cast<int>(code >> first & 511U);
        return static_cast<double>(bits >= 256 ? bits - 512 : bits);
    };
    return std::ldexp(unit, static_cast<int>(code >> 27U)) * dvec3(component(0), component(9), component(18));
}

}  // namespace gloam::reference
