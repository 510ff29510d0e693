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
// Subnormal numbers are read as 0. Error: 1e-7; of the weight 0.5 ULP. Over any number of frames errors add up to no
// more than 1e-7 (w_max + k) / k.
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

// exponential mean over frames (CS-G): `AO_n = AO_(n-1) + rate (AO - AO_(n-1)), AO where the history is not valid`
// [Gears of War 2 (Smedberg and Wright 2009)].
// It hides noise that changes from frame to frame, but gains nothing from frames in which nothing moves: for that see
// gloam_blend.
// history: occlusion of the last frame at the reprojected place. valid: whether it is the same surface (inside the
// image, depth agrees). current: occlusion of this frame. rate: in (0, 1], 0.1; above 1 counts as 1, below 0 as 0,
// NaN as 1.
// Returns occlusion in [0, 1], between history and current; current where the history is not valid or not in [0, 1],
// the history where current is not in [0, 1], 0 where neither is. Error: 2e-7.
float gloam_temporal_smooth(float history, bool valid, float current, float rate) {
    bool has_history = valid && history >= 0.0 && history <= 1.0;
    bool has_current = current >= 0.0 && current <= 1.0;
    if (!has_current) return has_history ? gloam_unit_interval(history) : 0.0;
    if (!has_history || !(rate < 1.0)) return gloam_unit_interval(current);
    float value = history + (current - history) * max(rate, 0.0);
    return gloam_unit_interval(clamp(value, min(history, current), max(history, current)));
}

// how far a pixel has converged (TSSAO-6): `conv = w / w_max` [TSSAO, eq 6].
// weight: w, accumulated samples. weight_max: w_max, in samples.
// Returns convergence in [0, 1]: 0 for a weight that is 0, negative or NaN, 1 from w_max on. 1 for w_max zero,
// subnormal, negative or NaN: nothing is to be accumulated then, so nothing is missing. Error: 2.5 ULP
// for w_max up to 2^126.
float gloam_convergence(float weight, float weight_max) {
    if (!(weight_max >= GLOAM_SMALLEST)) return 1.0;
    if (!(weight > 0.0)) return 0.0;
    return weight < weight_max ? min(weight / weight_max, 1.0) : 1.0;
}

// samples to take in this frame (TSSAO-AS): `k = k_1 if conv < c_spatial, else k_2` [TSSAO, adaptive sampling].
// convergence: conv in [0, 1], of the reprojected and validated history. c_spatial: 0.3.
// k_initial: 32. k_converged: 8 to 16.
// Returns a count >= 0 (a negative k counts as 0); k_initial as well for NaN in either: an unknown convergence is
// none. Error: none.
int gloam_sample_count(float convergence, float c_spatial, int k_initial, int k_converged) {
    return max(convergence >= c_spatial ? k_converged : k_initial, 0);
}

// whether the kernel is rotated at random (TSSAO-ROT): `conv < c_rot` [TSSAO, random rotation].
// Rotation turns banding into noise for the filter; later the plain sequence converges better.
// convergence: conv in [0, 1], of the reprojected and validated history. c_rot: 0.5.
// Returns true as well for NaN in either: an unknown convergence is none. Error: none.
bool gloam_rotation_enabled(float convergence, float c_rot) {
    return !(convergence >= c_rot);
}

#endif
