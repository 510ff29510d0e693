// SPDX-License-Identifier: MIT
#version 450
// Depth and normals of an engine, converted once a frame to what the other passes read (engine_inputs.glsl).
#include "passes/study/input_image.glsl"

#include "passes/engine_inputs.glsl"

layout(constant_id = 5) const bool has_normals = true;

// As the engine stores them, in any format; normals, stored and written, count when has_normals is set.
layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT stored_depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT stored_normal_image;
layout(binding = 2, r32f) uniform writeonly highp image2D depth_image;  // background +infinity
layout(binding = 3, rgba32f) uniform writeonly highp image2D normal_image;  // unit, 0 at the background; w is 0

layout(push_constant) uniform Parameters {
    mat3x4 view_from_world;  // a rotation in xyz; w is 0
    vec2 p22_p32;            // elements [2][2] and [3][2] of the projection, depth range [0, 1]
    ivec2 size;              // of the images, pixels
} parameters;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    float depth = linear_depth(GLOAM_FETCH(stored_depth_image, pixel).x, parameters.p22_p32);
    imageStore(depth_image, pixel, vec4(depth));
    if (!has_normals) return;
    vec3 normal = view_normal(GLOAM_FETCH(stored_normal_image, pixel).xyz, parameters.view_from_world);
    imageStore(normal_image, pixel, vec4(gloam_is_background(depth) ? vec3(0.0) : normal, 0.0));
}
