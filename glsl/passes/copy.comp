// SPDX-License-Identifier: MIT
#version 450
// Copies an image: one texel read and one written by each invocation. The least that a pass over all pixels
// can cost, and so the unit in which the time of others is told ("copies").
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  r32f  read
//   1  r32f  written, of the same size
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, r32f) uniform readonly image2D source_image;
layout(binding = 1, r32f) uniform writeonly image2D target_image;

layout(push_constant) uniform Parameters {
    ivec2 size;  // of the images, pixels
} parameters;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(target_image, pixel, imageLoad(source_image, pixel));
}
