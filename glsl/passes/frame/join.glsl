// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_JOIN_GLSL
#define GLOAM_PASSES_FRAME_JOIN_GLSL

// Filter and upsampling of the frame at half size, for compute and fragment shaders.

#include "gloam/filter/frame_texel.glsl"
#include "passes/frame/parameters.glsl"

const float inverse_tolerance = 1.0 / 0.02;  // of the relative difference of depth that counts as another surface

struct JoinParameters {
    vec2 inverse_half_size;  // of the texels
    vec2 inverse_size;       // of the view
};
FRAME_PARAMETERS(JoinParameters)

// The texel at a place, counted from that of the pixel's block.
GloamFrameTexel texel_at(ivec2 place);

// Occlusion of a pixel, in [0, 1]. odd: 0 for the first pixel of its block, else 1, in x and in y. depth: its own.
float joined(ivec2 odd, float depth) {
    float scale = inverse_tolerance / depth;
    vec2 sum = vec2(0.0, 1e-4);
    for (int y = -1; y <= 2; ++y) {
        for (int x = -1; x <= 2; ++x) {
            vec2 tent = max(2.0 - abs(vec2(x, y) - 0.5 * vec2(odd)), 0.0);
            if (tent.x * tent.y == 0.0) continue;
            GloamFrameTexel texel = texel_at(ivec2(x, y));
            sum += tent.x * tent.y * texel.weight * gloam_near(texel.depth, depth, scale) * vec2(texel.occlusion, 1.0);
        }
    }
    return sum.x / sum.y * (1.0 / 255.0);
}

#endif
