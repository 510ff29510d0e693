// SPDX-License-Identifier: MIT
#ifndef GLOAM_PREPARATION_PYRAMID_GLSL
#define GLOAM_PREPARATION_PYRAMID_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/camera.glsl"

// Surfaces at ever smaller resolutions, and what was found there, in one image of about the size of the full one: positions of level 1,
// of half the resolution, in its upper left quarter, normals in the upper right, results in the lower left, and in the fourth likewise
// the next level. A texel of level l stands for the block of 2^l x 2^l pixels that it covers, and the last of a row for what is left of
// one: sizes are rounded up, so that at any size texel i begins at pixel 2^l i and nothing drifts.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// Defined by the user: a texel of that image.
vec4 gloam_fetch_prepared(ivec2 pixel);

const int GLOAM_PYRAMID_POSITIONS = 0;
const int GLOAM_PYRAMID_NORMALS = 1;
const int GLOAM_PYRAMID_RESULTS = 2;

// That are worth having in an image: the coarsest one's texels are 256 pixels wide.
const uint GLOAM_MOST_RESOLUTIONS = 9u;

// The last level of so many resolutions, 0 for one.
int gloam_coarsest_level(uint resolutions) {
    return int(clamp(resolutions, 1u, GLOAM_MOST_RESOLUTIONS)) - 1;
}

// Size of a level of an image of `size` pixels; level 0 is the image.
ivec2 gloam_level_size(ivec2 size, int level) {
    return (size + ((1 << level) - 1)) >> level;
}

// Where in the image of all levels a texel lies.
// texel: inside its level, from 1. size: of the full image. kind: one of the three above.
ivec2 gloam_pyramid_texel(ivec2 texel, int level, ivec2 size, int kind) {
    ivec2 at = texel + gloam_level_size(size, level) * ivec2(kind & 1, kind >> 1);
    for (int l = 1; l < level; ++l) at += gloam_level_size(size, l);
    return at;
}

// Position of the surface that a texel stands for, view space, world units; the zero vector for background.
vec3 gloam_pyramid_position(ivec2 texel, int level, GloamCamera camera) {
    if (level > 0) return gloam_fetch_prepared(gloam_pyramid_texel(texel, level, camera.size, GLOAM_PYRAMID_POSITIONS)).xyz;
    float depth = gloam_fetch_depth(texel);
    return gloam_is_background(depth) ? vec3(0.0) : gloam_camera_position(texel, depth, camera);
}

#endif
