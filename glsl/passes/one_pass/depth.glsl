// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_ONE_PASS_DEPTH_GLSL
#define GLOAM_PASSES_ONE_PASS_DEPTH_GLSL

uniform highp sampler2D depth_image;

// Depth along the view axis, world units; background: 0 or infinite. Write it as your program stores depth.
// level: of texels that stand for 2^level pixels, 0 to 5. With levels: texelFetch(depth_image, pixel >> level, level).
float engine_depth(ivec2 pixel, int level) {
    return texelFetch(depth_image, pixel, 0).x;
}

#endif
