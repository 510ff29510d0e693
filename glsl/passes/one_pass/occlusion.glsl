// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_ONE_PASS_OCCLUSION_GLSL
#define GLOAM_PASSES_ONE_PASS_OCCLUSION_GLSL

// The sweep of the frame on what a program has: engine_depth() and, unless GLOAM_NORMALS_FROM_DEPTH, engine_normal().

#include "gloam/sampling/depth_levels.glsl"

// As occlusion_at() has them.
ivec2 depth_size;
float influence;

float depth_in_radii(ivec2 pixel, int level) {
    float depth = engine_depth(pixel, level) / influence;
    return depth > 0.0 && depth < GLOAM_FARTHEST_LEVEL_DEPTH ? depth : GLOAM_FARTHEST_LEVEL_DEPTH;
}

float tap_depth(vec2 at, float level) {
    return depth_in_radii(ivec2(at * vec2(depth_size - 1) + 0.5), int(clamp(level + 0.5, 0.0, 5.0)));
}

#ifdef GLOAM_NORMALS_FROM_DEPTH
float surface_depth(ivec2 pixel) {
    return pixel == clamp(pixel, ivec2(0), depth_size - 1) ? depth_in_radii(pixel, 0) : GLOAM_FARTHEST_LEVEL_DEPTH;
}
#endif

#define GLOAM_ONE_PASS
#include "passes/frame/sweep.glsl"

// Occlusion of a pixel that is drawn, 1 where blocked. size: of the depth, pixels. p00_p11: elements [0][0] and [1][1]
// of the projection, whose middle is that of the view. radius: of influence, world units.
float occlusion_at(ivec2 pixel, ivec2 size, vec2 p00_p11, float radius) {
    depth_size = size;
    influence = radius;
    vec2 step = 2.0 / (vec2(size) * p00_p11 * (orthographic ? radius : 1.0));
    parameters.inverse_span = 1.0 / vec2(size - 1);
    parameters.ray_span = step * vec2(size - 1);
    parameters.first_ray = -0.5 * parameters.ray_span;
    parameters.reach = 1.0 / step;
    return gloam_frame_texel(texel_of(pixel).x).occlusion / 255.0;
}

#endif
