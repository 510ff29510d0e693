// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_CONVERGENCE_WEIGHT_GLSL
#define GLOAM_FILTER_CONVERGENCE_WEIGHT_GLSL

#include "gloam/filter/gaussian.glsl"

// weight of a neighbour that has converged (TSSAO-10-weight): `coverage g(|p - x|) conv(x)` [TSSAO, eq 10].
// offset: p - x or x - p, world units. coverage: part of the neighbour in the window, [0, 1]; below 1e-30 it may count
// as 0. scale: of gloam_gaussian_scale, 1 / world units. convergence: conv(x), [0, 1].
// Returns a weight in [0, 1]; 0 for an infinite offset. Error: 5e-7.
float gloam_convergence_weight(vec3 offset, float coverage, float scale, float convergence) {
    return coverage * gloam_gaussian_scaled(dot(offset, offset), scale) * convergence;
}

#endif
