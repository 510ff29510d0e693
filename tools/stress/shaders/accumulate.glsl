// SPDX-License-Identifier: MIT
#ifndef STRESS_ACCUMULATE_GLSL
#define STRESS_ACCUMULATE_GLSL

#include "gloam/temporal/blend.glsl"
#include "gloam/temporal/history.glsl"

// What a pixel is given, frame after frame.
struct StressSequence {
    uint pattern;      // see stress_contribution
    uint seed;         // of the noise
    uint first;        // number of the first frame
    uint frames;       // of one call: below 65,535: lavapipe ends longer loops without a word
    uint k;            // samples a frame
    uint table_size;   // see gloam_next_index
    float weight_max;  // w_max
};

// A well-mixed 32-bit number for each number.
uint stress_hash(uint x) {
    x = (x ^ (x >> 16u)) * 0x7FEB352Du;
    x = (x ^ (x >> 15u)) * 0x846CA68Bu;
    return x ^ (x >> 16u);
}

// Contribution of a frame, a multiple of 2^-24.
// 0: a third; 1: 0 and 1 in turn; 2: jumps between 0 and 1 every 4096 frames; 3: noise; 4: 1 in one frame of 32.
float stress_contribution(StressSequence s, uint frame) {
    if (s.pattern == 0u) return 5592405.0 / 16777216.0;
    if (s.pattern == 1u) return float(frame & 1u);
    if (s.pattern == 2u) return float((frame >> 12u) & 1u);
    uint noise = stress_hash(frame ^ (s.seed * 0x9E3779B9u));
    if (s.pattern == 3u) return float(noise >> 8u) / 16777216.0;
    return noise < 0x08000000u ? 1.0 : 0.0;
}

// Depth of the surface that the pixel shows, in every frame.
const float STRESS_DEPTH = 3.0;

// The history texel after one more frame, as a pass makes it.
vec4 stress_frame(vec4 texel, float contribution, StressSequence s) {
    GloamHistory before = gloam_history_unpack(texel);
    vec2 blended = gloam_blend(before.occlusion, before.weight, contribution, float(s.k), s.weight_max);
    uint next = gloam_next_index(before.index, s.k, s.table_size);
    return gloam_history_pack(GloamHistory(blended.x, blended.y, next, STRESS_DEPTH));
}

// The history texel after all frames of the sequence.
// range: smallest and largest occlusion met so far; (-1, 2) once it was outside [0, 1] or NaN.
vec4 stress_accumulate(vec4 texel, StressSequence s, inout vec2 range) {
    for (uint i = 0u; i < s.frames; ++i) {
        texel = stress_frame(texel, stress_contribution(s, s.first + i), s);
        bool inside = texel.x >= 0.0 && texel.x <= 1.0;
        range = inside ? vec2(min(range.x, texel.x), max(range.y, texel.x)) : vec2(-1.0, 2.0);
    }
    return texel;
}

#endif
