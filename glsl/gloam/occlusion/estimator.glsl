// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_ESTIMATOR_GLSL
#define GLOAM_OCCLUSION_ESTIMATOR_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/sampling/unit_interval.glsl"

// clamped cosine of a sample's angle to the normal (TSSAO-1-cos): `max((s - p) . n / |s - p|, 0)` [TSSAO,
// eq 1 with the clamp it lacks in print].
// offset: s - p, any space and unit. normal: unit vector, same space.
// Returns a cosine in [0, 1]; 0 for an offset that is zero, subnormal, infinite or NaN, and for a NaN normal.
// Error: 3e-7.
float gloam_sample_cosine(vec3 offset, vec3 normal) {
    float cosine = dot(gloam_safe_normalize(offset, vec3(0.0)), normal);
    return cosine > 0.0 ? (cosine < 1.0 ? cosine : 1.0) : 0.0;
}

// The mean of contributions (TSSAO-2, and -4 for one frame's share of them): (1 / n) sum of C(p, s_i).

// one more contribution to a mean (TSSAO-2-add): `(sum + C, n + 1), C finite` [TSSAO, eqs 2 and 4].
// accumulated: (sum, count) so far, starting at (0, 0). contribution: C(p, s_i).
// Returns (sum + C, count + 1); unchanged for an infinite or NaN contribution, which is dropped and not counted.
// Counts are exact up to 2^24. Error: 0.5 ULP of the sum for each addition.
vec2 gloam_estimator_add(vec2 accumulated, float contribution) {
    return gloam_is_finite(contribution) ? accumulated + vec2(contribution, 1.0) : accumulated;
}

// mean of the contributions (TSSAO-2): `AO = (1 / n) sum of C(p, s_i)` [TSSAO, eqs 2 and 4].
// accumulated: (sum, count).
// Returns sum / count inside [0, 1], the occlusion; 0 for a count below 1 and for NaN. Error: 2.5 ULP.
float gloam_estimator_mean(vec2 accumulated) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 0.0;
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, 1.0) : 1.0;
}

// contribution of a sample point, as printed (TSSAO-3): `C = V D max(cos, 0)` [TSSAO, eq 3; Ritschel et al. 2009].
// Averaged over uniform directions it gives half the occlusion, over cosine-weighted ones two thirds of it where
// everything is blocked: the mean of the occlusion (TSSAO-1) is that of V D for cosine-weighted directions (TSSAO-14),
// and of 2 V D cos for uniform ones. Every argument is clamped to [0, 1], and NaN is read as 0.
// blocked: V, 1 blocked, 0 open. falloff: D in [0, 1] (1 for a kernel of uniform radii). cosine: of the angle to the
// normal.
// Returns a contribution in [0, 1]. Error: 1.5 ULP.
// No method or pass here calls it: it is TSSAO, eq 3, as printed; the methods draw directions by the cosine.
float gloam_contribution_ritschel(float blocked, float falloff, float cosine) {
    return gloam_unit_interval(blocked) * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

// contribution of a sample point, uniform directions (TSSAO-3-uniform): `C = 2 V D max(cos, 0)` [TSSAO,
// eq 3 normalised for density 1 / (2 pi)].
// blocked, falloff, cosine: as for gloam_contribution_ritschel.
// Returns a contribution in [0, 2] whose mean is the occlusion: clamp the mean, not the contribution. Error: 1.5 ULP.
// No method or pass here calls it: it is TSSAO, eq 3, for uniform directions; the methods draw by the cosine.
float gloam_contribution_uniform_directions(float blocked, float falloff, float cosine) {
    // 2 V: a factor 2 of the product would be moved behind it by Mesa's OpenGL, and the smaller product flushed to 0.
    float twice = blocked > 0.0 ? (blocked < 1.0 ? 2.0 * blocked : 2.0) : 0.0;
    return twice * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

#endif
