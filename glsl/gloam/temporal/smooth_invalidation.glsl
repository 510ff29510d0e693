// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_SMOOTH_INVALIDATION_GLSL
#define GLOAM_TEMPORAL_SMOOTH_INVALIDATION_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/sampling/unit_interval.glsl"

// What happens to the weight of a pixel whose neighbourhood has changed but which itself has not been disoccluded
// (TSSAO-SI; a disoccluded pixel starts again with weight 0). Two forms are published: (a) clamps the sample count to
// 32 to 64 samples, (b) scales it by a confidence with a factor of 15 to 30. The numbers are different quantities.

// smooth invalidation by clamping the weight (TSSAO-SI-a): `w := min(w, w_small)` [TSSAO, notes on
// smooth invalidation].
// Form (a).
// weight: w, accumulated samples. weight_small: w_small, 32 to 64 samples.
// Returns the weight, >= 0; 0 for a negative or NaN argument. Error: none.
float gloam_invalidate_clamp(float weight, float weight_small) {
    if (!(weight > 0.0 && weight_small > 0.0)) return 0.0;
    return weight < weight_small ? weight : weight_small;
}

// confidence in the history after a change (TSSAO-SI-b): `conf = 1 / (1 + S d)` [TSSAO, smooth invalidation factor].
// Form (b). Of several neighbours the smallest confidence counts.
// change: d >= 0 (gloam_neighborhood_change; its magnitude is taken), over the kernel radius to be independent of
// scale.
// factor: S >= 0, 15 to 30, in 1 / unit of the change; a negative factor is read as 0.
// Returns a confidence in [0, 1]: 1 for no change, 1/2 at d = 1 / S; 0 for an infinite or NaN change or factor, and
// where it would be subnormal. Error: 3 ULP.
float gloam_confidence(float change, float factor) {
    float d = abs(change);
    if (!(d <= GLOAM_LARGEST && abs(factor) <= GLOAM_LARGEST)) return 0.0;
    float x = factor > 0.0 ? factor * d : 0.0;
    return x <= GLOAM_LARGEST_DIVISOR ? min(1.0 / (1.0 + x), 1.0) : 0.0;
}

// smooth invalidation by a confidence (TSSAO-SI-b-weight): `w := conf w` [TSSAO, smooth invalidation factor].
// Form (b), weight after a change: conf w.
// weight: w, accumulated samples. confidence: conf; read inside [0, 1], NaN as 0.
// Returns the weight, >= 0; 0 for a negative, infinite or NaN weight. Error: 0.5 ULP.
float gloam_invalidate_confidence(float weight, float confidence) {
    if (!(weight > 0.0 && weight <= GLOAM_LARGEST)) return 0.0;
    return weight * gloam_unit_interval(confidence);
}

#endif
