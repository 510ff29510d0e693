// SPDX-License-Identifier: MIT
#version 450
// The frame, last pass at full size: a mean over 3 x 3 or 5 x 5 pixels, weighted by the slices' weight and by depth.
// One invocation for each two pixels side by side.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
// Dispatch ceil(size / (32, 8)) groups. Descriptor set 0:
//   0  r32ui   texels of sweep.comp; nearest, clamped to the edge
//   1  output  written: occlusion, in [0, 1]
// In sequences (history.glsl):
//   2          the history of the frame before; bilinear, clamped to the edge
//   3          level 0 of the depth of the frame before; nearest, clamped to the edge
//   4  rgb10_a2  written: the history
layout(local_size_x = 16, local_size_y = 8) in;

#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
layout(binding = 0) uniform highp usampler2D texel_image;
layout(binding = 1, GLOAM_OUTPUT) uniform writeonly highp image2D result_image;
layout(binding = 2) uniform highp sampler2D before_image;
layout(binding = 3) uniform highp sampler2D depth_before_image;
layout(binding = 4, rgb10_a2) uniform writeonly highp image2D history_image;
#ifdef GLOAM_BENT_NORMALS
layout(binding = 5) uniform highp sampler2D bend_image;                    // of sweep.comp; as its texels
layout(binding = 6, rgb10_a2) uniform writeonly highp image2D bent_image;  // written: (0.5 + 0.5 bent, 1)
layout(binding = 7) uniform highp sampler2D bent_before_image;  // of the frame before; bilinear, clamped
#endif

#include "passes/frame/history.glsl"

GloamFrameTexel texels[6][6];

GloamFrameTexel texel_at(ivec2 place) {
    return texels[place.y][place.x];
}

#include "passes/frame/filter.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) * ivec2(2, 1);
    vec2 corner = vec2(pixel + 1 - half_width) * parameters.inverse_texels;
#ifdef GLOAM_BENT_NORMALS
    first_bend = corner - 0.5 * parameters.inverse_texels;
#endif
    for (int y = 0; y < 2 * half_width + 1; y += 2) {
        for (int x = 0; x < 2 * half_width + 2; x += 2) {
            uvec4 four = textureGather(texel_image, corner + vec2(x, y) * parameters.inverse_texels).wzxy;  // by rows
            for (int i = 0; i < 4; ++i) texels[y + i / 2][x + i % 2] = gloam_frame_texel(four[i]);
        }
    }
    for (int odd = 0; odd < 2; ++odd) {
        ivec2 own = pixel + ivec2(odd, 0);
        ivec2 place = ivec2(half_width + odd, half_width);
        float moved = moved_around(ivec2(half_width));
        vec4 kept;
        imageStore(result_image, own, vec4(accumulated(own, texel_at(place).depth, filtered(place), moved, kept)));
#ifdef GLOAM_BENT_NORMALS
        imageStore(bent_image, own, vec4(0.5 * bent + 0.5, 1.0));
#endif
        if (history) imageStore(history_image, own, kept);
    }
}
