// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_PIXELS_GLSL
#define GLOAM_GATHER_PIXELS_GLSL

// Three values for each of several resolutions in one image, which has about the size of the full image. For level 1,
// half the resolution, the first value is in the upper left quarter, the second in the upper right, the third in the
// lower left. The lower right quarter contains level 2 in the same arrangement, and so on.
// A texel of level l represents the block of 2^l x 2^l pixels that it covers; the last of a row represents the rest of
// a block. Sizes are rounded up, so that texel i begins at pixel 2^l i at any image size and nothing drifts.

// Size of a level of an image of `size` pixels; level 0 is the image.
ivec2 gloam_level_size(ivec2 size, int level) {
    return (size + ((1 << level) - 1)) >> level;
}

// Where in the image of all levels a texel lies.
// texel: inside its level, from 1. size: of the full image. kind: which of the values, 0 to 2.
ivec2 gloam_pyramid_texel(ivec2 texel, int level, ivec2 size, int kind) {
    ivec2 at = texel + gloam_level_size(size, level) * ivec2(kind & 1, kind >> 1);
    for (int l = 1; l < level; ++l) at += gloam_level_size(size, l);
    return at;
}

// Taps in the same pixel read the same depth, so one of them is enough (ISSAO, in prose). With uniform radii such taps
// are near the shaded pixel. A bit for each of the 8 x 8 pixels around it makes these distinct. (Searching a list of
// the pixels read took ten times as long as the saved taps.)

// The pixels around the shaded one that the taps have read.
struct GloamDistinctPixels {
    ivec2 center;  // the shaded pixel; the others lie 4 to its left and above, 3 to its right and below
    uvec2 seen;    // a bit for each pixel: four rows of 8, and four more; 0 before the first tap
};

// Adds the pixel of a tap.
// Returns false for a pixel of those 8 x 8 that was added before, else true. Error: none.
bool gloam_distinct_add(inout GloamDistinctPixels known, ivec2 pixel) {
    ivec2 at = pixel - known.center + 4;
    if (at.x < 0 || at.y < 0 || at.x > 7 || at.y > 7) return true;
    uint bit = 1u << uint((at.y & 3) * 8 + at.x);
    uvec2 bits = at.y < 4 ? uvec2(bit, 0u) : uvec2(0u, bit);
    bool fresh = (known.seen & bits) == uvec2(0u);
    known.seen |= bits;
    return fresh;
}

#endif
