// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_BIAS_GLSL
#define GLOAM_OCCLUSION_BIAS_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"

// bias that grows with the depth (BIAS-depth): `b d / d_ref` [McGuire et al. 2011; psi(z) of ISSAO, eq 6].
// Bias against self-occlusion that grows with the depth, as the rounding error of positions does: b d / d_ref. It is
// the psi(z) of the improved method (ISSAO-6), and with d_ref = 1 the beta z of Alchemy's estimator (CS-3.10). That one
// prints + beta; z is negative in view space, so the bias is subtracted.
// bias: b, world units at the reference depth, >= 0. depth: d, eye-linear, world units. reference_depth: d_ref, world
// units, > 0.
// Returns a length in world units, in [0, FLT_MAX]; 0 for background depth, and for b or d_ref that is not positive
// or NaN. The contributions subtract it from the height above the tangent plane. Error: 2.5 ULP.
float gloam_depth_bias(float bias, float depth, float reference_depth) {
    if (gloam_is_background(depth) ||
        !(bias > 0.0 && reference_depth >= GLOAM_SMALLEST && reference_depth <= GLOAM_LARGEST_DIVISOR))
        return 0.0;
    float scaled = bias * (depth / reference_depth);
    return scaled <= GLOAM_LARGEST ? scaled : (scaled > 0.0 ? GLOAM_LARGEST : 0.0);
}

#endif
