// SPDX-License-Identifier: MIT
#ifndef GLOAM_PREPARATION_DEPTH_CHAIN_GLSL
#define GLOAM_PREPARATION_DEPTH_CHAIN_GLSL

#include "gloam/sampling/tap_pixel.glsl"

// Levels 1 to 5 of the depth chain in one image: level 1 at the upper left, the others in a column to its right.

// Where in that image a texel of a level lies.
// texel: inside its level, from 1. size: of the full image, pixels.
ivec2 gloam_chain_texel(ivec2 texel, int level, ivec2 size) {
    if (level <= 1) return texel;
    ivec2 at = texel + ivec2(gloam_depth_mip_size(size, 1).x, 0);
    for (int l = 2; l < level; ++l) at.y += gloam_depth_mip_size(size, l).y;
    return at;
}

#endif
