// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_PYRAMID_GLSL
#define GLOAM_GATHER_PYRAMID_GLSL

// Several values of ever smaller resolutions in one image of about the size of the full one: of level 1, of half the
// resolution, the first value in its upper left quarter, the second in the upper right, the third in the lower left,
// and in the fourth likewise the next level. A texel of level l stands for the block of 2^l x 2^l pixels that it
// covers, and the last of a row for what is left of one: sizes are rounded up, so that at any size texel i begins at
// pixel 2^l i and nothing drifts.

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
