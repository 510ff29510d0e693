// SPDX-License-Identifier: MIT
#version 450
// The frame, last pass at full size: a mean over 3 x 3 or 5 x 5 pixels, weighted by the slices' weight and by depth.
// One invocation for each two pixels side by side.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
// Dispatch ceil(size / (32, 8)) groups. Descriptor set 0:
//   0  r32ui   texels of sweep.comp; nearest, clamped to the edge
//   1  output  written: occlusion, in [0, 1]
layout(local_size_x = 16, local_size_y = 8) in;

layout(constant_id = 0) const int half_width = 1;  // 1: 3 x 3 pixels; 2: 5 x 5
#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
layout(binding = 0) uniform highp usampler2D texel_image;
layout(binding = 1, GLOAM_OUTPUT) uniform writeonly highp image2D result_image;

layout(push_constant) uniform Parameters {
    vec2 inverse_size;
    float inverse_tolerance;  // of the relative difference of depth that counts as another surface
} parameters;

#include "gloam/filter/frame_texel.glsl"

const float falloff = 0.18;  // weights of 5 x 5 fall by 2^-(0.18 r^2)

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy) * ivec2(2, 1);
    vec2 corner = vec2(pixel + 1 - half_width) * parameters.inverse_size;
    GloamFrameTexel texels[6][6];
    for (int y = 0; y < 2 * half_width + 1; y += 2) {
        for (int x = 0; x < 2 * half_width + 2; x += 2) {
            uvec4 four = textureGather(texel_image, corner + vec2(x, y) * parameters.inverse_size);
            texels[y][x] = gloam_frame_texel(four.w);
            texels[y][x + 1] = gloam_frame_texel(four.z);
            texels[y + 1][x] = gloam_frame_texel(four.x);
            texels[y + 1][x + 1] = gloam_frame_texel(four.y);
        }
    }
    for (int side = 0; side < 2; ++side) {
        GloamFrameTexel own = texels[half_width][half_width + side];
        float scale = parameters.inverse_tolerance / own.depth;
        vec2 sum = vec2(0.0, 1e-4);
        for (int y = 0; y < 2 * half_width + 1; ++y) {
            for (int x = 0; x < 2 * half_width + 1; ++x) {
                GloamFrameTexel texel = texels[y][x + side];
                vec2 offset = vec2(x - half_width, y - half_width);
                float near = offset == vec2(0.0) ? 1.0 : gloam_near(texel.depth, own.depth, scale);
                float spatial = half_width == 1 ? 1.0 : exp2(-falloff * dot(offset, offset));
                float weight = spatial * texel.weight * near;
                sum += weight * vec2(texel.occlusion, 1.0);
            }
        }
        imageStore(result_image, pixel + ivec2(side, 0), vec4(sum.x / sum.y * (1.0 / 255.0)));
    }
}
