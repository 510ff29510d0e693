// SPDX-License-Identifier: MIT
#version 450
// The frame, first pass: depth as the engine stores it becomes eye-linear depth of 16 bits (deep views: 32), in radii,
// with levels (gloam/sampling/depth_levels.glsl). What is no depth becomes the largest, so that no later pass tests for
// it. One invocation for each 2 x 2 pixels: dispatch ceil(ceil(size / 2) / (16, 8)) groups. Bindings are those of
// descriptor set 0. Samplers take the nearest texel and clamp to the edge.
//
// Define GLOAM_LEVELS as r32f for deep views (parameters.glsl); the default is r16f.
#ifndef GLOAM_LEVELS
#define GLOAM_LEVELS r16f
#endif
layout(local_size_x = 16, local_size_y = 8) in;

layout(binding = 0) uniform highp sampler2D stored_image;  // depth as the engine stores it, in x
// Levels are negative where the frame before did not show the surface.
layout(binding = 1, GLOAM_LEVELS) uniform writeonly highp image2D level_0;
layout(binding = 2, GLOAM_LEVELS) uniform writeonly highp image2D level_1;
layout(binding = 3, GLOAM_LEVELS) uniform writeonly highp image2D level_2;
layout(binding = 4, GLOAM_LEVELS) uniform writeonly highp image2D level_3;
layout(binding = 5, GLOAM_LEVELS) uniform writeonly highp image2D level_4;
layout(binding = 6) uniform highp sampler2D depth_before_image;  // level 0 of the frame before, in sequences

vec4 levels_before(vec2 at) {
    return textureGather(depth_before_image, at);
}

#include "passes/frame/prepare.glsl"
#include "passes/frame/tile_list.glsl"

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
#ifdef GLOAM_TILES
    if (block == ivec2(0)) empty_lists();
#endif
    ivec2 pixel = 2 * block;
    vec4 stored = textureGather(stored_image, vec2(pixel + 1) * parameters.inverse_size);
    vec4 depth = vec4(depth_of(stored.w), depth_of(stored.z), depth_of(stored.x), depth_of(stored.y));
    depth *= sign_of(pixel, depth.x);
    for (int i = 0; i < 4; ++i) imageStore(level_0, pixel + ivec2(i % 2, i / 2), vec4(depth[i]));
    imageStore(level_1, block, depth.wwww);
    if (gloam_is_level_middle(block, 2)) imageStore(level_2, block >> 1, depth.xxxx);
    if (gloam_is_level_middle(block, 3)) imageStore(level_3, block >> 2, depth.xxxx);
    if (gloam_is_level_middle(block, 4)) imageStore(level_4, block >> 3, depth.xxxx);
}
