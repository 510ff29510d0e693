// SPDX-License-Identifier: MIT
#version 450
// Inputs of the effect at half the resolution: of each 2 x 2 pixels the first one (gloam/filter/half_resolution.glsl).
// Depth stays as it is. Normals and positions become those of the view space in which the half-size image has its
// camera in the middle. One invocation a pixel of the half-size images.
//
// Dispatch ceil(ceil(size / 2) / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  rgba32f  view-space normal facing the eye in xyz
//   2  rgba32f  xyz: where each surface point was, in the view space of the previous frame; read when moving_objects is
//               set
//   3  rgba32f  depth layers 1 to 3 behind binding 0 in xyz; read when has_layers is set
//   4  r32f     written: depth
//   5  rgba32f  written: normal in xyz; w is 0
//   6  rgba32f  written when moving_objects is set: previous position in xyz; w is 0
//   7  rgba32f  written when has_layers is set: depth layers
#include "passes/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool orthographic = false;           // this frame's camera; else perspective
layout(constant_id = 1) const bool previous_orthographic = false;  // the previous frame's
layout(constant_id = 2) const bool moving_objects = false;
layout(constant_id = 3) const bool has_layers = false;

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT previous_position_image;
layout(binding = 3 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT layer_image;
layout(binding = 4, r32f) uniform writeonly highp image2D half_depth_image;
layout(binding = 5, rgba32f) uniform writeonly highp image2D half_normal_image;
layout(binding = 6, rgba32f) uniform writeonly highp image2D half_previous_position_image;
layout(binding = 7, rgba32f) uniform writeonly highp image2D half_layer_image;

layout(push_constant) uniform Parameters {
    vec2 p00_p11;           // elements [0][0] and [1][1] of the projection, y down
    vec2 previous_p00_p11;  // of the previous frame's
    ivec2 size;             // of the full-size images, pixels
} parameters;

#include "gloam/filter/half_resolution.glsl"

vec2 shift_of(vec2 p00_p11) {
    return vec2(gloam_half_shift(p00_p11.x, parameters.size.x), gloam_half_shift(p00_p11.y, parameters.size.y));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = gloam_half_size(parameters.size);
    if (pixel.x >= size.x || pixel.y >= size.y) return;
    ivec2 source = gloam_half_source(pixel);
    imageStore(half_depth_image, pixel, GLOAM_FETCH(depth_image, source));
    vec2 shift = shift_of(parameters.p00_p11);
    vec3 normal = GLOAM_FETCH(normal_image, source).xyz;
    imageStore(half_normal_image, pixel, vec4(orthographic ? normal : gloam_half_normal(normal, shift), 0.0));
    if (moving_objects) {
        vec3 position = GLOAM_FETCH(previous_position_image, source).xyz;
        position.xy += (previous_orthographic ? 1.0 : -position.z) * shift_of(parameters.previous_p00_p11);
        imageStore(half_previous_position_image, pixel, vec4(position, 0.0));
    }
    if (has_layers) imageStore(half_layer_image, pixel, GLOAM_FETCH(layer_image, source));
}
