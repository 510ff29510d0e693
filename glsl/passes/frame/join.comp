// SPDX-License-Identifier: MIT
#version 450
// The frame, last pass at half size: filter and upsampling in one. A pixel takes the 3 x 3 to 4 x 4 texels around it,
// weighted by a tent, by the slices' weight and by depth. One invocation for each 2 x 2 pixels of the view.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
// Dispatch ceil(ceil(size / 2) / (16, 8)) groups. Descriptor set 0:
//   0  r32ui   texels of sweep.comp, of every second pixel; nearest, clamped to the edge
//   1  r16f    depth of prepare.comp; likewise
//   2  output  written: occlusion, in [0, 1]
layout(local_size_x = 16, local_size_y = 8) in;

#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
layout(binding = 0) uniform highp usampler2D texel_image;
layout(binding = 1) uniform highp sampler2D depth_image;
layout(binding = 2, GLOAM_OUTPUT) uniform writeonly highp image2D result_image;

layout(push_constant) uniform Parameters {
    vec2 inverse_half_size;   // of the texels
    vec2 inverse_size;        // of the view
    float inverse_tolerance;  // of the relative difference of depth that counts as another surface
} parameters;

#include "gloam/filter/frame_texel.glsl"

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
    ivec2 pixel = 2 * block;
    vec2 corner = vec2(block) * parameters.inverse_half_size;
    uint codes[4][4];
    for (int y = 0; y < 4; y += 2) {
        for (int x = 0; x < 4; x += 2) {
            uvec4 four = textureGather(texel_image, corner + vec2(x, y) * parameters.inverse_half_size);
            codes[y][x] = four.w;
            codes[y][x + 1] = four.z;
            codes[y + 1][x] = four.x;
            codes[y + 1][x + 1] = four.y;
        }
    }
    vec4 own = textureGather(depth_image, vec2(pixel + 1) * parameters.inverse_size).wzxy;  // by rows
    vec4 scale = parameters.inverse_tolerance / own;
    vec4 sum = vec4(0.0);
    vec4 whole = vec4(1e-4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 4; ++x) {
            GloamFrameTexel texel = gloam_frame_texel(codes[y][x]);
            for (int i = 0; i < 4; ++i) {
                vec2 tent = max(2.0 - abs(vec2(x - 1, y - 1) - 0.5 * vec2(i & 1, i >> 1)), 0.0);
                if (tent.x * tent.y == 0.0) continue;
                float weight = tent.x * tent.y * texel.weight * gloam_near(texel.depth, own[i], scale[i]);
                sum[i] += weight * texel.occlusion;
                whole[i] += weight;
            }
        }
    }
    vec4 occlusion = sum / whole * (1.0 / 255.0);
    for (int i = 0; i < 4; ++i) imageStore(result_image, pixel + ivec2(i & 1, i >> 1), vec4(occlusion[i]));
}
