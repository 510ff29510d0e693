// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_ESTIMATOR_GLSL
#define GLOAM_OCCLUSION_ESTIMATOR_GLSL

#include "gloam/geometry/finite.glsl"

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

#endif
