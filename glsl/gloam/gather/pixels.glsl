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

#endif
