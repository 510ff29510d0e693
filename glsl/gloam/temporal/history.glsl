// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_HISTORY_GLSL
#define GLOAM_TEMPORAL_HISTORY_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/sampling/unit_interval.glsl"

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
// Each as a float, sanitized first. Channels of 32 bits hold everything exactly. Channels of 16 bits hold integers
// (index and weight) only up to 2048, and make the depth too coarse for the depth test (TSSAO-9). They also stop the
// mean short of its limit by up to 2.5e-4 (w_max + k) / k: 0.0041 for k = 32 and w_max = 500, 0.046 for k = 8 and w_max
// = 1500.
// h: any history. Error: none.
vec4 gloam_history_pack(GloamHistory h) {
    GloamHistory s = gloam_history_sanitize(h);
    return vec4(s.occlusion, s.weight, float(s.index), s.depth);
}

// history from a texel (TSSAO-BUF-unpack): `(AO, w, j, d)` [TSSAO, layout of the ambient-occlusion buffer].
// Sanitized: whatever the texel holds, the result is usable.
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

// whether the history is of the same surface (TSSAO-8): `|d' - d~| < epsilon d', d~ the point's depth in the previous
// camera` [TSSAO, eq 8].
// Not symmetric: accepts expected depths in (stored (1 - epsilon), stored (1 + epsilon)).
// stored_depth: d_(f-1), eye-linear, read without interpolation at the reprojected point, world units.
// expected_depth: depth that the current surface point had in the previous camera (gloam_previous_depth), world
// units. Its depth in the current camera would reject every pixel of a camera that moves forward.
// epsilon: relative, 0.01 to 0.05; at 0, negative or NaN nothing passes.
// Returns false as well if either depth is background or NaN. A difference within rounding of the threshold may fall to
// either side. Depths above 1e-30.
bool gloam_depth_consistent(float stored_depth, float expected_depth, float epsilon) {
    // An infinite depth differs by infinity or NaN, which is below nothing.
    bool surfaces = stored_depth >= GLOAM_SMALLEST && expected_depth >= GLOAM_SMALLEST;
    return surfaces && abs(stored_depth - expected_depth) < epsilon * stored_depth;
}

// Bilinear interpolation of the history that leaves out texels of another surface. The four texels are, in this order,
// (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1) with (x, y) = floor(uv size - 1/2).

// weights of bilinear interpolation (BILINEAR): `((1 - x)(1 - y), x (1 - y), (1 - x) y, x y)` [definition].
// fraction: fract(uv size - 1/2), in [0, 1]^2; taken to the nearer end outside, 0 for NaN.
// Returns weights in [0, 1] of sum 1. Error: 2.5 ULP each.
vec4 gloam_bilinear_weights(vec2 fraction) {
    vec2 f = vec2(gloam_unit_interval(fraction.x), gloam_unit_interval(fraction.y));
    vec2 g = 1.0 - f;
    return vec4(g.x * g.y, f.x * g.y, g.x * f.y, f.x * f.y);
}

// bilinear weights of the valid texels only (BILINEAR-valid): `w_i / (sum of valid w)` [TSSAO, interpolation across
// depth edges].
// bilinear: weights as above; each read inside [0, 1], NaN as 0. valid: which texels passed their test
// (gloam_depth_consistent).
// Returns weights in [0, 1] of sum 1, 0 for invalid texels; all 0 where no valid texel has a weight that is not zero or
// subnormal. Error: 3 ULP each.
vec4 gloam_validated_weights(vec4 bilinear, bvec4 valid) {
    vec4 w = vec4(valid.x ? gloam_unit_interval(bilinear.x) : 0.0, valid.y ? gloam_unit_interval(bilinear.y) : 0.0,
                  valid.z ? gloam_unit_interval(bilinear.z) : 0.0, valid.w ? gloam_unit_interval(bilinear.w) : 0.0);
    float sum = (w.x + w.y) + (w.z + w.w);
    return sum >= GLOAM_SMALLEST ? min(w / sum, vec4(1.0)) : vec4(0.0);
}

#endif
