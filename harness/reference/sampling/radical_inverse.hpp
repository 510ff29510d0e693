// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_radical_inverse_base2(unsigned index) {
    unsigned bits = (index << 16U) | (index >> 16U);
    bits = ((bits & 0x00FF00FFU) << 8U) | ((bits >> 8U) & 0x00FF00FFU);
    bits = ((bits & 0x0F0F0F0FU) << 4U) | ((bits >> 4U) & 0x0F0F0F0FU);
    bits = ((bits & 0x33333333U) << 2U) | ((bits >> 2U) & 0x33333333U);
    bits = ((bits & 0x55555555U) << 1U) | ((bits >> 1U) & 0x55555555U);
    return double(bits >> 8U) * 5.9604644775390625e-8;
}

inline double gloam_radical_inverse(unsigned index, unsigned base) {
    const unsigned radix = clamp(base, 2U, 0x01000000U);
    unsigned rest = index & 0x00FFFFFFU;
    unsigned mirrored = 0U;
    unsigned power = 1U;
    for (; rest >= radix; rest /= radix) {
        mirrored = mirrored * radix + rest % radix;
        power *= radix;
    }
    const double inverse = (mirrored + double(rest) / double(radix)) / double(power);
    return min(inverse, 0.999999940395355);
}

}  // namespace gloam::reference
