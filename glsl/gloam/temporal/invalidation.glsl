// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_INVALIDATION_GLSL
#define GLOAM_TEMPORAL_INVALIDATION_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/arithmetic.glsl"
#include "gloam/sampling/unit_interval.glsl"

// change of the distance to a neighbouring point (TSSAO-9): `||s - p| - |s' - p'||` [TSSAO, eq 9].
// Common motion of both leaves it 0. With a = s - p and b = s' - p' it is |(a - b) . (a + b)| / (|a| + |b|), which
// subtracts before squaring: the error is that of a and b, not that of their lengths.
// sample_position: s, position: p, of this frame; previous_sample: s', previous_position: p', of the previous one.
// World units, one space for each frame; camera-centred positions keep s - p exact.
// Returns the change in world units, >= 0; the largest float, which counts as changed for every threshold, where a
// position or difference is infinite or NaN. Error: 6 ULP where s - p and s' - p' are exact, else 2e-7 of the larger
// length besides.
// No method or pass here calls it: it is TSSAO, eq 9; the pass takes gloam_probe_change, which has no branch.
float gloam_neighborhood_change(vec3 sample_position, vec3 position, vec3 previous_sample, vec3 previous_position) {
    vec3 a = sample_position - position;
    vec3 b = previous_sample - previous_position;
    if (!(gloam_is_finite3(a) && gloam_is_finite3(b))) return GLOAM_LARGEST;
    vec3 bounds = max(abs(a), abs(b));
    float largest = max(max(bounds.x, bounds.y), bounds.z);
    if (!(largest >= GLOAM_SMALLEST)) return 0.0;
    // Powers of two, so exact: lengths beyond 2^32 or below 2^-32 are squared on another scale.
    float scale = largest > 4294967296.0 ? 8.271806125530277e-25
                                         : (largest < 2.3283064365386963e-10 ? 1.2089258196146292e24 : 1.0);
    a *= scale;
    b *= scale;
    float sum = gloam_sqrt(dot(a, a)) + gloam_sqrt(dot(b, b));
    return min(abs(dot(a - b, a + b)) / sum / scale, GLOAM_LARGEST);
}

// whether a neighbourhood counts as unchanged (TSSAO-9-test): `d <= epsilon` [TSSAO, notes on eq 9].
// change: d, world units. epsilon: world units, 0.01 to 0.05 of the kernel radius.
// Returns false for NaN in either, and for the largest float, which stands for a bad input. Error: none.
bool gloam_neighborhood_unchanged(float change, float epsilon) {
    return change <= epsilon && change < GLOAM_LARGEST;
}

// whether a surface point can block another at all (TSSAO-9-probe): `(s - p) . n > 0` [TSSAO, eq 9].
// What lies below the tangent plane cannot block, however it moves.
// offset: s - p, world units. normal: n, unit vector, same space.
// Returns false for an offset that is zero, infinite or NaN. A point within rounding of the plane may fall to either
// side.
// No method or pass here calls it: it is TSSAO, eq 9; the pass takes gloam_probe_change, which has no branch.
bool gloam_probe_useful(vec3 offset, vec3 normal) {
    return gloam_is_finite3(offset) && dot(offset, normal) > 0.0;
}

// change of the distance to a sample that may block (TSSAO-9-reach): `||a| - |b|| if min(|a|, |b|) <= r and a . n > 0,
// else 0` [TSSAO, eq 9].
// gloam_neighborhood_change for the surface points under samples, without a branch. What could not block the point in
// either frame does not count. Lengths are subtracted here; that they lose digits does not matter within the reach.
// now: a, from the point to the sample, world units. before: b, the same in the previous frame, in any space: the
// camera's own motion changes no distance. normal: n of the point, unit vector, space of a. reach: r, how far what
// blocks may be, world units, >= 0.
// Returns the change in world units, >= 0; 0 for what does not count; the largest float, as gloam_neighborhood_change,
// where a, b or n is infinite or NaN. Lengths are below 1e18. Error: 1.5e-7 of the larger length.
float gloam_probe_change(vec3 now, vec3 before, vec3 normal, float reach) {
    float squared = dot(now, now);
    float squared_before = dot(before, before);
    bool counts = !(squared > reach * reach && squared_before > reach * reach) && dot(now, normal) > 0.0;
    float change = counts ? abs(sqrt(squared) - sqrt(squared_before)) : 0.0;
    bool known = all(bvec3(gloam_is_finite3(now), gloam_is_finite3(before), gloam_is_finite3(normal)));
    return known && change <= GLOAM_LARGEST ? change : GLOAM_LARGEST;
}

// What happens to the weight of a pixel whose neighbourhood has changed but which itself has not been disoccluded
// (TSSAO-SI; a disoccluded pixel starts again with weight 0). Two forms are published: (a) clamps the sample count to
// 32 to 64 samples, (b) scales it by a confidence with a factor of 15 to 30. The numbers are different quantities.
// Print has no formula for (b), only the factor: the one here is reconstructed.

// smooth invalidation by clamping the weight (TSSAO-SI-a): `w := min(w, w_small)` [TSSAO, notes on
// smooth invalidation].
// weight: w, accumulated samples. weight_small: w_small, 32 to 64 samples.
// Returns the weight, >= 0; 0 for a negative or NaN argument. Error: none.
float gloam_invalidate_clamp(float weight, float weight_small) {
    if (!(weight > 0.0 && weight_small > 0.0)) return 0.0;
    return weight < weight_small ? weight : weight_small;
}

// confidence in the history after a change (TSSAO-SI-b): `conf = 1 / (1 + S d)` [TSSAO, smooth invalidation factor,
// reconstructed].
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

// smooth invalidation by a confidence (TSSAO-SI-b-weight): `w := conf w` [TSSAO, smooth invalidation factor,
// reconstructed].
// weight: w, accumulated samples. confidence: conf; read inside [0, 1], NaN as 0.
// Returns the weight, >= 0; 0 for a negative, infinite or NaN weight. Error: 0.5 ULP.
float gloam_invalidate_confidence(float weight, float confidence) {
    if (!(weight > 0.0 && weight <= GLOAM_LARGEST)) return 0.0;
    return weight * gloam_unit_interval(confidence);
}

// The form that a setting chooses.
const uint GLOAM_INVALIDATION_CLAMP = 1u;
const uint GLOAM_INVALIDATION_CONFIDENCE = 2u;

// samples that a history keeps after a change (TSSAO-SI): `min(w, w_small) where d > t; or w / (1 + S max(d - t, 0) /
// R)` [TSSAO, notes on smooth invalidation].
// weight: w, samples, >= 0. change: d, of gloam_probe_change. radius: R, of influence, world units, > 0. invalidation:
// GLOAM_INVALIDATION_*; any other number: nothing is lost. tolerance: t, world units, >= 0: less is rounding, and must
// not eat the history of a scene at rest. weight_small: w_small, samples, > 0. factor: S, per radius of change.
// Returns samples in [0, w]. Error: 4 ULP and what the difference loses, but for changes within rounding of t.
float gloam_invalidated_weight(float weight, float change, float radius, uint invalidation, float tolerance,
                               float weight_small, float factor) {
    if (invalidation == GLOAM_INVALIDATION_CLAMP)
        return gloam_neighborhood_unchanged(change, tolerance) ? weight : gloam_invalidate_clamp(weight, weight_small);
    if (invalidation != GLOAM_INVALIDATION_CONFIDENCE) return weight;
    return gloam_invalidate_confidence(weight, gloam_confidence(max(change - tolerance, 0.0) / radius, factor));
}

#endif
