// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_FRAME_TEXEL_GLSL
#define GLOAM_FILTER_FRAME_TEXEL_GLSL

// What the filter of the frame reads of a pixel, in 32 bits: depth 16, occlusion 8, whether something moved, weight 7.
struct GloamFrameTexel {
    float depth;      // in radii of influence
    float occlusion;  // in 1/255
    float weight;     // of the occlusion, in 1/255 of 1.6, the most that a slice counts
    uint moved;       // 1 where a tap met what the frame before did not show; else 0
};

// Added to the code of such a pixel.
const uint GLOAM_FRAME_MOVED = 0x1000000u;

#if defined(GL_ES) || __VERSION__ >= 420
#define GLOAM_PACKS_HALF
#endif
// From the exponent of a half float to that of a float, as its bits.
const uint GLOAM_HALF_SHIFT = 0x38000000u;

// a pixel in 32 bits (FRAME-texel): `half(d) | round(255 AO) << 16 | round(127 w / 1.6) << 25` [gloam].
// depth: that of a half float, from 2^-14 to 65504; nothing is rounded. occlusion: in [0, 1]. weight: in [0, 1.6].
// Returns the bits; bit 24 is 0. Error: none but for values within rounding of the middle of two codes.
uint gloam_frame_code(float depth, float occlusion, float weight) {
    uvec2 codes = uvec2(vec2(255.0, 127.0 / 1.6) * vec2(occlusion, weight) + 0.5);
#ifdef GLOAM_PACKS_HALF
    uint bits = packHalf2x16(vec2(depth, 0.0));
#else
    uint bits = (floatBitsToUint(depth) - GLOAM_HALF_SHIFT) >> 13u;
#endif
    return bits | codes.x << 16u | codes.y << 25u;
}

// pixel of 32 bits (FRAME-texel-of): `the inverse of FRAME-texel` [gloam].
// code: its lower 16 bits are a half float from 2^-14. Bit 24 adds at most 1/255 to the weight. Error: none.
GloamFrameTexel gloam_frame_texel(uint code) {
#ifdef GLOAM_PACKS_HALF
    return GloamFrameTexel(unpackHalf2x16(code).x, float(code >> 16u & 0xFFu), float(code >> 24u), code >> 24u & 1u);
#else
    float depth = uintBitsToFloat(((code & 0xFFFFu) << 13u) + GLOAM_HALF_SHIFT);
    return GloamFrameTexel(depth, float(code >> 16u & 0xFFu), float(code >> 24u), code >> 24u & 1u);
#endif
}

// weights of two neighbours on opposite sides by their depths (FRAME-near): `max(clamp(1.25 - |d1 + d2 - 2 d0| /
// (t d0), 0, 1), a - |di - d0| / (r d0))` [gloam].
// Together they count by the bend of the surface between them, so that its slant costs nothing and grooves and edges
// are kept; alone, where something else is on the other side, less, by their own depths.
// depths: (d1, d2), > 0. own: d0, > 0. scale: 1 / (t d0), t the relative bend that counts as an edge, and 1 / (r d0).
// alone: a, weight of one without the other, in [0, 1].
// Returns weights in [0, 1]. Error: 2e-7.
vec2 gloam_near_pair(vec2 depths, float own, vec2 scale, float alone) {
    vec2 apart = depths - own;
    float together = clamp(1.25 - abs(apart.x + apart.y) * scale.x, 0.0, 1.0);
    return alone > 0.0 ? max(vec2(together), alone - abs(apart) * scale.y) : vec2(together);
}

// how much the occlusion varies in a tile (FRAME-mark): `sqrt(n sum_i o_i^2 - (sum_i o_i)^2) / n` [gloam].
// The standard deviation of its texels at half size: where it is large, half size does not suffice: at contacts, edges
// and thin parts. All texels tell, so that the noise of single ones moves it less than it moves their range.
// sum, squares: of o and of o^2 over the texels, o in [0, 255]: whole numbers, since single precision loses a small
// difference of two large ones. count: n, in [1, 64].
// Returns a deviation in the unit of o. Error: 3e-5.
float gloam_tile_deviation(uint sum, uint squares, uint count) {
    return sqrt(float(count * squares - sum * sum)) / float(count);
}

#endif
