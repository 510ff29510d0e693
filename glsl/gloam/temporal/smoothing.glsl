// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_SMOOTHING_GLSL
#define GLOAM_TEMPORAL_SMOOTHING_GLSL

#include "gloam/sampling/unit_interval.glsl"

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

#endif
