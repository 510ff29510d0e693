// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_ROTATION_GLSL
#define GLOAM_SAMPLING_ROTATION_GLSL

#include "gloam/numeric/sincos.glsl"

// What rotates many samples by one angle turns them by its cosine and sine, computed once: not every driver moves
// them out of a loop.

// disc sample turned by the cosine and sine of an angle (TSSAO-ROT-turn-disc): `(c x - s y, s x + c y)` [TSSAO,
// random rotation].
// s: point of the unit disc (any vector of length below 1e19). turn: (cos, sin) of the angle, as gloam_sincos gives it.
// Returns s rotated counter-clockwise, of the same length; infinite or NaN for a longer, infinite or NaN s.
// Error: 3 ulp of the largest component, while that is above 1e-30; shorter vectors may be flushed to 0.
vec2 gloam_turn_disc(vec2 s, vec2 turn) {
    return vec2(turn.x * s.x - turn.y * s.y, turn.y * s.x + turn.x * s.y);
}

// hemisphere sample turned by the cosine and sine of an angle (TSSAO-ROT-turn-hemisphere): `(c x - s y, s x + c y, z)`
// [TSSAO, random rotation].
// s: point of the unit half ball in tangent space, z along the normal. All else as for gloam_turn_disc: s is rotated
// counter-clockwise seen from the tip of the normal, and keeps its angle to the normal.
vec3 gloam_turn_hemisphere(vec3 s, vec2 turn) {
    return vec3(gloam_turn_disc(s.xy, turn), s.z);
}

// disc sample rotated about the centre (TSSAO-ROT-disc): `(c x - s y, s x + c y)` [TSSAO, random rotation].
// angle: radians, counter-clockwise, |angle| <= 65536; anything else, NaN included, rotates by 0.
// s and what it returns: as for gloam_turn_disc, but for an error of 4 ulp.
vec2 gloam_rotate_disc(vec2 s, float angle) {
    return gloam_turn_disc(s, gloam_sincos(angle));
}

// hemisphere sample rotated about the normal (TSSAO-ROT-hemisphere): `(c x - s y, s x + c y, z)` [TSSAO,
// random rotation].
// angle: as for gloam_rotate_disc. s and what it returns: as for gloam_turn_hemisphere, but for an error of 4 ulp.
vec3 gloam_rotate_hemisphere(vec3 s, float angle) {
    return gloam_turn_hemisphere(s, gloam_sincos(angle));
}

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

// rotation angle of a pixel on a lattice (LATTICE-ROT): `2 pi fract(x / g^3 + y / g), g the golden ratio` [gloam; the
// sequences of Roberts 2018, over pixels].
// The pixels of every small window have angles far from each other, so a filter leaves less noise than with angles at
// random. The same is true of fract(14 t), t the angle's turns: gloam_slice_sample takes its jitter from it.
// pixel: integer pixel; the products are modulo 2^32. Returns an angle in radians, in [0, 2 pi]. Error: 3 ulp or 4e-9.
float gloam_lattice_rotation(ivec2 pixel) {
    uvec2 turns = uvec2(pixel) * uvec2(1013904243u, 2654435769u);  // 2^32 / g^3, 2^32 / g
    return float(turns.x + turns.y) * 1.46291807926716e-9;  // 2 pi / 2^32
}

#endif
