// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_SAMPLE_BUDGET_GLSL
#define GLOAM_TEMPORAL_SAMPLE_BUDGET_GLSL

// samples to take in this frame (TSSAO-AS): `k = k_1 if conv < c_spatial, else k_2` [TSSAO, adaptive sampling].
// convergence: conv in [0, 1], of the reprojected and validated history. c_spatial: 0.3.
// k_initial: 32. k_converged: 8 to 16.
// Returns a count >= 0 (a negative k counts as 0); k_initial as well for NaN in either: an unknown convergence is
// none. Error: none.
int gloam_sample_count(float convergence, float c_spatial, int k_initial, int k_converged) {
    return max(convergence >= c_spatial ? k_converged : k_initial, 0);
}

#endif
