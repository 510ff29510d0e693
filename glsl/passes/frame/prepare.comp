// SPDX-License-Identifier: MIT
#version 450
// The frame, first pass: depth as the engine stores it becomes eye-linear depth of 16 bits, in radii of influence, with
// levels (gloam/sampling/depth_levels.glsl). What is no depth becomes the largest, so that no later pass tests for it.
// One invocation for each 2 x 2 pixels.
//
// Dispatch ceil(ceil(size / 2) / (16, 8)) groups. Descriptor set 0:
//   0        depth as the engine stores it, in x; nearest texel, clamped to the edge
//   1 to 5   r16f  written: levels 0 to 4; negative where the frame before did not show the surface
//   6        level 0 of the frame before, in sequences; nearest texel, clamped to the edge
layout(local_size_x = 16, local_size_y = 8) in;

layout(constant_id = 1) const bool orthographic = false;  // both cameras; else perspective
layout(constant_id = 8) const bool history = false;       // there was a frame before

layout(binding = 0) uniform highp sampler2D stored_image;
layout(binding = 1, r16f) uniform writeonly highp image2D level_0;
layout(binding = 2, r16f) uniform writeonly highp image2D level_1;
layout(binding = 3, r16f) uniform writeonly highp image2D level_2;
layout(binding = 4, r16f) uniform writeonly highp image2D level_3;
layout(binding = 5, r16f) uniform writeonly highp image2D level_4;

layout(binding = 6) uniform highp sampler2D depth_before_image;

layout(push_constant) uniform Parameters {
    mat4x3 before;   // where a pixel's point was (gloam/temporal/frame_history.glsl)
    vec2 numerator;  // of depth in radii (gloam/sampling/depth_levels.glsl)
    vec2 divisor;
    vec2 inverse_size;
    float far;
} parameters;

#include "gloam/sampling/depth_levels.glsl"
#include "gloam/temporal/frame_history.glsl"

float depth_of(float stored) {
    return gloam_level_depth(stored, parameters.numerator, parameters.divisor, parameters.far);
}

// -1 where the frame before did not show the surface of a pixel, which stands for its block; else 1.
float sign_of(ivec2 pixel, float depth) {
    if (!history) return 1.0;
    vec3 was = gloam_frame_before(vec2(pixel), depth, parameters.before[0], parameters.before[1], parameters.before[2],
                                  parameters.before[3], orthographic);
    vec4 before = abs(textureGather(depth_before_image, was.xy));
    return gloam_frame_moved(was.z, before, 0.5 * GLOAM_FARTHEST_LEVEL_DEPTH, 0.01) ? -1.0 : 1.0;
}

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 pixel = 2 * block;
    vec4 stored = textureGather(stored_image, vec2(pixel + 1) * parameters.inverse_size);
    float depth = depth_of(stored.w);
    float sign = sign_of(pixel, depth);
    vec4 first = vec4(sign * depth);
    vec4 last = vec4(sign * depth_of(stored.y));
    imageStore(level_0, pixel, first);
    imageStore(level_0, pixel + ivec2(1, 0), vec4(sign * depth_of(stored.z)));
    imageStore(level_0, pixel + ivec2(0, 1), vec4(sign * depth_of(stored.x)));
    imageStore(level_0, pixel + 1, last);
    imageStore(level_1, block, last);
    if (gloam_is_level_middle(block, 2)) imageStore(level_2, block >> 1, first);
    if (gloam_is_level_middle(block, 3)) imageStore(level_3, block >> 2, first);
    if (gloam_is_level_middle(block, 4)) imageStore(level_4, block >> 3, first);
}
