// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_BIT_COUNT_GLSL
#define GLOAM_NUMERIC_BIT_COUNT_GLSL

// number of bits set (BIT-count): `sum of the digits in base 2` [definition].
// Number of bits set, in languages with and without bitCount() (GLSL before 4.00 and ESSL before 3.10 lack it).
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
