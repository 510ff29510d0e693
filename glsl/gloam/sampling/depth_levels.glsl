// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_DEPTH_LEVELS_GLSL
#define GLOAM_SAMPLING_DEPTH_LEVELS_GLSL

// Depth of 16 bits with levels, of which taps far from their pixel read the small ones. Depth is in radii of influence,
// so that no scale of the world matters: what is beyond the largest half float has a radius of far less than a pixel.

// Depth of the background, and the largest: the largest half float, radii.
const float GLOAM_FARTHEST_LEVEL_DEPTH = 65504.0;

// depth as levels hold it, of what an engine stores (FRAME-depth): `d = (n0 + n1 b) / (q0 + q1 b) where 0 < d < 65504
// and b is not the far end, else 65504` [the projection solved for depth].
// Of a buffer of the range [0, 1] (gloam/geometry/linear_depth.glsl), perspective, d is P32 / (P22 + b); orthographic,
// (P32 - b) / P22. What is eye-linear has (0, 1) and (1, 0). The radius belongs to the numerator.
// stored: b. far: the value of the background in the buffer, 1 or, reversed, 0; where there is none, infinity.
// Returns a depth in (0, 65504]; 65504 for background and NaN. Error: 3 ulp, of inputs within 4 ulp; b from 1e-30.
float gloam_level_depth(float stored, vec2 numerator, vec2 divisor, float far) {
    float depth = (numerator.x + numerator.y * stored) / (divisor.x + divisor.y * stored);
    return stored != far && depth > 0.0 && depth < GLOAM_FARTHEST_LEVEL_DEPTH ? depth : GLOAM_FARTHEST_LEVEL_DEPTH;
}

// level that a tap reads (FRAME-level): `log2(h) - 4.3, h in pixels` [gloam; XeGTAO (Strugar 2021)].
// As gloam_depth_mip_level, but with parts of a level, for a sampler that takes the nearest one that there is. With
// XeGTAO's 3.3 in the place of 4.3 the error of the frame is 1 % larger.
// pixels: h, distance of the tap from its pixel, > 0, at most 16384. Error: 2e-6.
float gloam_depth_level(float pixels) {
    return log2(pixels) - 4.3;
}

// whether a block of 2 x 2 pixels has the middle of a texel of a level (FRAME-middle): `block mod 2^(l - 1) = 2^(l - 2)
// in x and y` [gloam].
// Texel c of level l takes its depth from pixel 2^l c + 2^(l - 1). For l >= 2 this is the first pixel of a block; for
// level 1, the last one of block c.
// block: its first pixel / 2, >= 0. level: 2 to 30. Error: none.
bool gloam_is_level_middle(ivec2 block, int level) {
    return ((block.x | block.y) & ((1 << (level - 2)) - 1)) == 0 && ((block.x & block.y) >> (level - 2) & 1) == 1;
}

#endif
