// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HASH_ROTATION_GLSL
#define GLOAM_SAMPLING_HASH_ROTATION_GLSL

// 10 h radians as a part of a turn (HASH-turn): `floor(2^32 frac(10 h / (2 pi)))` [fixed-point arithmetic of 64 bits].
// h: any 32-bit integer.
// Returns the floor of the fraction times 2^32, at most one off. Integer arithmetic, because 10 h in float has lost
// every digit of the angle when h is large.
uint gloam_hash_turn(uint h) {
    // frac(10 / (2 pi)) = 0x976FC893C3AA34E9 / 2^64. The product is kept modulo 2^64 and its high word returned.
    uint h0 = h & 0xFFFFu;
    uint h1 = h >> 16u;
    uint low = h0 * 0x34E9u;
    uint cross0 = h1 * 0x34E9u + (low >> 16u);
    uint cross1 = h0 * 0xC3AAu + (cross0 & 0xFFFFu);
    uint high = h1 * 0xC3AAu + (cross0 >> 16u) + (cross1 >> 16u);
    return high + h * 0x976FC893u;
}

// rotation angle of a pixel by a hash (HASH-ROT): `10 ((3 x) XOR (y + x y)) modulo 2 pi` [McGuire et al., Alchemy and
// Scalable Ambient Obscurance shaders].
// pixel: integer pixel; the hash is computed modulo 2^32, so negative and large coordinates wrap and are allowed.
// Returns an angle in radians, in [0, 2 pi). Error: 3 ulp or 4e-9.
float gloam_hash_rotation(ivec2 pixel) {
    uint x = uint(pixel.x);
    uint y = uint(pixel.y);
    uint turn = gloam_hash_turn((3u * x) ^ (y + x * y));
    // 2 pi / 2^32; rounding must not reach 2 pi.
    return min(float(turn) * 1.46291807926716e-9, 6.283185005);
}

#endif
