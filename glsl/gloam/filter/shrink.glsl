// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_SHRINK_GLSL
#define GLOAM_FILTER_SHRINK_GLSL

// Factor on the filter's support in the image (TSSAO-11): max(c - conv, 0) / c. Pixels that have converged are not filtered.
// convergence: conv; below 0 it is read as 0, NaN gives 1. c_adaptive: c, 0.2: the convergence from which nothing is filtered.
// Returns a factor in [0, 1]: 1 for no convergence, falling linearly to 0 at c. 0 for c zero, subnormal, negative or NaN; 1 for infinite
// c and finite conv.
float gloam_shrink(float convergence, float c_adaptive) {
    if (!(c_adaptive >= 1.175494351e-38) || convergence >= c_adaptive) return 0.0;
    if (!(convergence > 0.0) || c_adaptive > 3.402823466e38) return 1.0;
    return (c_adaptive - convergence) / c_adaptive;
}

#endif
