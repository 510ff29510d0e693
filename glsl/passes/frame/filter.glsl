// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_FILTER_GLSL
#define GLOAM_PASSES_FRAME_FILTER_GLSL

// The filter of the frame at full size, for compute and fragment shaders.

#include "gloam/filter/frame_texel.glsl"
#include "passes/frame/history.glsl"
#include "passes/frame/parameters.glsl"

layout(constant_id = 0) const int half_width = 1;  // 1: 3 x 3 pixels; 2: 5 x 5

const float inverse_tolerance = 1.0 / 0.011;  // of the relative difference of depth that counts as another surface
const float falloff = 0.18;                   // weights of 5 x 5 fall by 2^-(0.18 r^2)

struct FilterParameters {
    HistoryParameters history;
    vec2 inverse_size;
};
FRAME_PARAMETERS(FilterParameters)

// The texel at a place among those that an invocation reads.
GloamFrameTexel texel_at(ivec2 place);

// Sums of the pixel at a place: of its own occlusion and weight, and of all.
vec4 filtered(ivec2 middle) {
    GloamFrameTexel own = texel_at(middle);
    float scale = inverse_tolerance / own.depth;
    vec2 sum = vec2(0.0, 1e-4);
    for (int y = -half_width; y <= half_width; ++y) {
        for (int x = -half_width; x <= half_width; ++x) {
            GloamFrameTexel texel = texel_at(middle + ivec2(x, y));
            vec2 offset = vec2(x, y);
            float near = offset == vec2(0.0) ? 1.0 : gloam_near(texel.depth, own.depth, scale);
            float spatial = half_width == 1 ? 1.0 : exp2(-falloff * dot(offset, offset));
            sum += spatial * texel.weight * near * vec2(texel.occlusion, 1.0);
        }
    }
    return vec4(own.weight * vec2(own.occlusion, 1.0), sum) * vec2(1.0 / 255.0, 1.0).xyxy;
}

// Share of the texels around two pixels side by side whose taps met what moved: 1 from a half on. first: place of the
// first of the two.
float moved_around(ivec2 first) {
    uint moved = 0u;
    for (int y = -1; y <= 1; ++y)
        for (int x = 0; x <= 1; ++x) moved += texel_at(first + ivec2(x, y)).moved;
    return min(float(moved) * (1.0 / 3.0), 1.0);
}

// Occlusion of a pixel, and the texel for the next frame. first: place of the first of two side by side; odd: 1 for
// the other.
float shown(ivec2 pixel, ivec2 first, int odd, out vec4 kept) {
    ivec2 place = first + ivec2(odd, 0);
    return accumulated(pixel, texel_at(place).depth, filtered(place), moved_around(first), parameters.history, kept);
}

#endif
