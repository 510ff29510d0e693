// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_ARITHMETIC_GLSL
#define GLOAM_NUMERIC_ARITHMETIC_GLSL

#include "gloam/numeric/constants.glsl"

// square root that is 0 at 0 (SQRT): `x^(1/2), 0 for x <= 0` [x times its inverse square root].
// Vulkan derives sqrt() from 1 / inversesqrt(): 4.5 ulp, and undefined at 0.
// x: any float.
// Returns the square root; 0 for a number that is zero, subnormal, negative or NaN, infinity for infinity.
// Error: 7 ulp whatever the rounding, 2.5 ulp where it is to nearest.
float gloam_sqrt(float x) {
    return x >= GLOAM_SMALLEST ? (x <= GLOAM_LARGEST ? x * inversesqrt(x) : x) : 0.0;
}

// the smaller over the larger of two lengths (RATIO): `a / b, 0 <= a <= b` [definition].
// smaller, larger: 0 <= smaller <= larger, at any scale; a subnormal larger one is read as the smallest normal number.
// Returns a ratio in [0, 1]; 0 for a finite over an infinite length, 1 for two infinite ones. Error: 2.5 ulp.
float gloam_length_ratio(float smaller, float larger) {
    if (larger > GLOAM_LARGEST) return smaller > GLOAM_LARGEST ? 1.0 : 0.0;
    // Vulkan says nothing of quotients by less than 2^-126 or more than 2^126.
    float scale = larger > GLOAM_LARGEST_DIVISOR ? 0.25 : 1.0;
    GLOAM_PRECISE float ratio = smaller * scale / (max(larger, GLOAM_SMALLEST) * scale);
    return min(ratio, 1.0);
}

// number of bits set (BIT-count): `sum of the digits in base 2` [definition].
// In languages with and without bitCount() (GLSL before 4.00 and ESSL before 3.10 lack it).
// bits: any 32 bits.
// Returns a number in [0, 32]. Error: none.
uint gloam_bit_count(uint bits) {
#if (defined(GL_ES) && __VERSION__ >= 310) || (!defined(GL_ES) && __VERSION__ >= 400)
    return uint(bitCount(bits));
#else
    uint pairs = bits - ((bits >> 1u) & 0x55555555u);
    uint nibbles = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
    return (((nibbles + (nibbles >> 4u)) & 0x0F0F0F0Fu) * 0x01010101u) >> 24u;
#endif
}

#endif
