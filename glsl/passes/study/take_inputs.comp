// SPDX-License-Identifier: MIT
#version 450
// Depth and normals of an engine, converted once a frame to what the other passes read (engine_inputs.glsl). One
// invocation a pixel.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0           depth as the engine stores it, in x; any format
//   1           normals as the engine stores them; any format; read when has_normals is set
//   2  r32f     written: eye-linear depth, world units; background +infinity
//   3  rgba32f  written when has_normals is set: view-space unit normal in xyz, 0 at the background; w is 0
#include "passes/study/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#include "passes/engine_inputs.glsl"

layout(constant_id = 5) const bool has_normals = true;

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT stored_depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT stored_normal_image;
layout(binding = 2, r32f) uniform writeonly highp image2D depth_image;
layout(binding = 3, rgba32f) uniform writeonly highp image2D normal_image;

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
