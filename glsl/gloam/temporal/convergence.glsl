// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_CONVERGENCE_GLSL
#define GLOAM_TEMPORAL_CONVERGENCE_GLSL

#include "gloam/numeric/constants.glsl"

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

#endif
