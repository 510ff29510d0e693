// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_HISTORY_GLSL
#define GLOAM_TEMPORAL_HISTORY_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"

// What a pixel remembers from frame to frame (TSSAO-BUF). Occlusion and weight may be fetched with interpolation; the
// index and the depth must not (TSSAO-7).
struct GloamHistory {
    float occlusion;  // blended occlusion, 1 = blocked
    float weight;     // accumulated samples
    uint index;       // j, samples of the sequence already used
    float depth;      // eye-linear depth, world units; +infinity for background
};

// The largest table of samples: indices below it are exact in a float.
const uint GLOAM_LARGEST_TABLE = 16777216u;

// history of a pixel that has none (TSSAO-BUF-empty): `(0, 0, 0, d), d = infinity for background` [TSSAO,
// layout of the ambient-occlusion buffer].
// depth: eye-linear depth, world units; every background depth becomes +infinity.
// Error: none.
GloamHistory gloam_history_empty(float depth) {
    return GloamHistory(0.0, 0.0, 0u, gloam_is_background(depth) ? gloam_background_depth() : depth);
}

// whether a history holds a mean (TSSAO-BUF-usable): `0 <= AO <= 1 and 0 < w < infinity` [TSSAO,
// layout of the ambient-occlusion buffer].
// Subnormal numbers of either sign are read as 0.
// occlusion, weight: any. Error: none.
bool gloam_history_usable(float occlusion, float weight) {
    return occlusion > -GLOAM_SMALLEST && occlusion <= 1.0 && weight >= GLOAM_SMALLEST && weight <= GLOAM_LARGEST;
}

// history made safe to use (TSSAO-BUF-sanitize): `h if 0 <= AO <= 1, 0 < w < infinity and d is geometry, else empty`
// [TSSAO, layout of the ambient-occlusion buffer].
// It becomes the empty history of its depth where its occlusion is outside [0, 1] or NaN, its weight is not positive
// and finite, or its pixel is background. The index is then 0 too, so every fresh start is the same. Else the index is
// taken modulo 2^24. Subnormal numbers of either sign are read as 0.
// h: any history. Error: none.
GloamHistory gloam_history_sanitize(GloamHistory h) {
    bool usable = gloam_history_usable(h.occlusion, h.weight);
    if (!usable || gloam_is_background(h.depth)) return gloam_history_empty(h.depth);
    return GloamHistory(h.occlusion >= GLOAM_SMALLEST ? h.occlusion : 0.0, h.weight, h.index % GLOAM_LARGEST_TABLE,
                        h.depth);
}

// texel of the history buffer (TSSAO-BUF-pack): `(AO, w, j, d)` [TSSAO, layout of the ambient-occlusion buffer].
// Texel of the history buffer: (occlusion, weight, index, depth), each as a float, sanitized first. Channels of 32 bits
// hold everything exactly. Channels of 16 bits hold integers (index and weight) only up to 2048, and make the depth
// too coarse for the depth test (TSSAO-9). They also stop the mean short of its limit by up to
// 2.5e-4 (w_max + k) / k: 0.0041 for k = 32 and w_max = 500, 0.046 for k = 8 and w_max = 1500 (docs/copy-a-shader.md).
// h: any history. Error: none.
vec4 gloam_history_pack(GloamHistory h) {
    GloamHistory s = gloam_history_sanitize(h);
    return vec4(s.occlusion, s.weight, float(s.index), s.depth);
}

// history from a texel (TSSAO-BUF-unpack): `(AO, w, j, d)` [TSSAO, layout of the ambient-occlusion buffer].
// History from a texel, sanitized; whatever the texel holds, the result is usable.
// texel: (occlusion, weight, index, depth). An index that is negative, 2^24 or more or NaN is read as 0, a fraction
// is dropped.
// Error: none.
GloamHistory gloam_history_unpack(vec4 texel) {
    uint index = texel.z >= 1.0 && texel.z < 16777216.0 ? uint(texel.z) : 0u;
    return gloam_history_sanitize(GloamHistory(texel.x, texel.y, index, texel.w));
}

// start index of the next frame (TSSAO-BUF-index): `(j + k) mod N` [TSSAO, layout of the ambient-occlusion buffer].
// index: j. k: samples taken. table_size: N, samples until the sequence starts over, at most 2^24; 0 and more than
// that count as 2^24 (at most 2048 for a 16-bit buffer).
// Returns an index in [0, N - 1], without overflow. Error: none.
uint gloam_next_index(uint index, uint k, uint table_size) {
    uint size = table_size > 0u && table_size < GLOAM_LARGEST_TABLE ? table_size : GLOAM_LARGEST_TABLE;
    return (index % size + k % size) % size;
}

#endif
