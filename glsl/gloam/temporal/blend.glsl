// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_BLEND_GLSL
#define GLOAM_TEMPORAL_BLEND_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/sampling/unit_interval.glsl"

// weight of a history value, if it can be one (TSSAO-5-weight): `min(w', w_max) if 0 <= AO' <= 1, else 0` [TSSAO,
// edges of eq 5].
// history: AO_(f-1). weight: w_(f-1), in samples. weight_max: w_max, in samples.
// Returns a weight in [0, max(w_max, 0)], finite: 0 for a history outside [0, 1] or NaN and for a weight or w_max not
// positive or NaN. Subnormal numbers of either sign are read as 0. Error: none.
float gloam_history_weight(float history, float weight, float weight_max) {
    if (!(history > -GLOAM_SMALLEST && history <= 1.0)) return 0.0;
    if (!(weight >= GLOAM_SMALLEST && weight_max >= GLOAM_SMALLEST)) return 0.0;
    float cap = weight_max <= GLOAM_LARGEST ? weight_max : GLOAM_LARGEST;
    return weight < cap ? weight : cap;
}

// blend of the history with new samples (TSSAO-5): `AO = AO' + (C - AO') k / (w' + k);  w = min(w' + k, w_max)` [TSSAO,
// eqs 4 and 5, arguments corrected].
// The weight in the denominator is the reprojected one, w_(f-1)(p_(f-1)). Written as the value of larger
// weight plus its part of the difference, AO_(f-1) + (C - AO_(f-1)) k / (w + k) or C + (AO_(f-1) - C) w / (w + k): it
// never leaves the range between the two, cannot overflow and keeps a constant exactly. While the weight is below
// w_max this is the plain mean of all samples, then an exponential average with the factor k / (w_max + k).
// history: AO_(f-1) in [0, 1], at the reprojected point. weight: w_(f-1) there, in samples, >= 0; read inside [0,
// w_max].
// contribution: C, mean of the k new samples, in [0, 1] (taken to the nearer end outside). k: new samples, >= 0.
// weight_max: w_max in samples, 500 to 1500, at most 2^24 - k for exact counts; 0, negative or NaN keeps no history.
// Returns (AO, new weight). An unusable history (outside [0, 1], NaN) has weight 0. Weight 0 gives C exactly. k = 0,
// negative, infinite or NaN, and an infinite or NaN C leave the history as it is; with weight 0 that is (0, 0).
// Subnormal numbers are read as 0.
// Error: 1e-7; of the weight 0.5 ULP. Over any number of frames errors add up to no more than
// 1e-7 (w_max + k) / k.
vec2 gloam_blend(float history, float weight, float contribution, float k, float weight_max) {
    float w = gloam_history_weight(history, weight, weight_max);
    float old = w > 0.0 && history >= GLOAM_SMALLEST ? history : 0.0;
    if (!(k >= GLOAM_SMALLEST && k <= GLOAM_LARGEST && abs(contribution) <= GLOAM_LARGEST)) return vec2(old, w);
    float fresh = gloam_unit_interval(contribution);
    float cap = weight_max >= GLOAM_SMALLEST ? min(weight_max, GLOAM_LARGEST) : 0.0;
    float total = w + k;
    float blended = w < k ? fresh + (old - fresh) * (w / total) : old + (fresh - old) * (k / total);
    return vec2(blended, total < cap ? total : cap);
}

#endif
