// SPDX-License-Identifier: MIT
#version 450
// Copies an image: each invocation reads one texel and writes one. This is the least that a pass over all pixels can
// cost. Its time is therefore the unit for the times of other passes ("copies").
//
// Define GLOAM_FORMAT as the format of both images (default: r32f), and GLOAM_INTEGERS where it holds unsigned
// integers. Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  read
//   1  written, of the same size
#ifndef GLOAM_FORMAT
#define GLOAM_FORMAT r32f
#endif
#ifdef GLOAM_INTEGERS
#define GLOAM_COPIED uimage2D
#else
#define GLOAM_COPIED image2D
#endif
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, GLOAM_FORMAT) uniform readonly highp GLOAM_COPIED source_image;
layout(binding = 1, GLOAM_FORMAT) uniform writeonly highp GLOAM_COPIED target_image;

layout(push_constant) uniform Parameters {
    ivec2 size;  // of the images, pixels
} parameters;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(target_image, pixel, imageLoad(source_image, pixel));
}
