// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_GAUSSIAN_GLSL
#define GLOAM_FILTER_GAUSSIAN_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/finite.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/precise.glsl"

// scale of distances for the Gaussian (TSSAO-10-g-scale): `s = sqrt(log2(e) / 2) / sigma` [TSSAO, eq 10].
// For gloam_gaussian_scaled, a factor that all neighbours of a pixel share. It is not squared, because the square could
// overflow or underflow.
// sigma: standard deviation, world units, >= 0.
// Returns the scale, in 1 / world units, from 2^-101 to 2^126 for all but three kinds of sigma: a zero, subnormal or
// negative one is read as 2^-126, of which no distance but 0 counts; above 2^100 (and for infinity) 0, with which
// every finite distance counts wholly; for NaN infinity, with which nothing counts. Error: 2.5 ULP.
float gloam_gaussian_scale(float sigma) {
    if (gloam_is_nan(sigma)) return uintBitsToFloat(0x7F800000u);
    return sigma <= 1.2676506e30 ? 0.8493218003 / max(sigma, GLOAM_SMALLEST) : 0.0;
}

// weight of a neighbour by the scale of the Gaussian (TSSAO-10-g-scaled): `g = 2^-(d s)^2` [TSSAO, eq 10].
// It is exp(-d^2 / (2 sigma^2)), by its distance in the world.
// squared_distance: d^2, world units squared, of which the sign does not count. scale: of gloam_gaussian_scale, 1 /
// world units.
// Returns a weight in [0, 1], not below 1e-30 unless 0. 0 for infinity or NaN in either, else 1 for distance 0 or
// scale 0.
// Error: 3e-7; 5e-7 by any device that keeps Vulkan's rules for exp2(), 3 + 2 x ULP of a weight of 2^-x: the smallest
// weights hold to 3e-5 of themselves.
float gloam_gaussian_scaled(float squared_distance, float scale) {
    // In this order: the square of the scale may be beyond the largest float, or subnormal.
    GLOAM_PRECISE float x = abs(squared_distance) * scale * scale;
    float weight = min(exp2(-x), 1.0);
    return x <= 99.5 ? weight : 0.0;
}

// weight of a neighbour by its distance in the world (TSSAO-10-g): `g = exp(-d^2 / (2 sigma^2))` [TSSAO, eq 10].
// Depth edges need no further term.
// squared_distance: d^2, world units squared, of which the sign does not count. sigma: world units, >= 0.
// Returns a weight in [0, 1], not below 1e-30 unless 0. For sigma zero, subnormal or negative: 1 at distance 0, else
// 0. An infinite distance gives 0, an infinite sigma 1 at every finite one, NaN in either 0. Error: 3e-7; 1e-6 by any
// device that keeps Vulkan's rules for exp2() and division.
float gloam_gaussian(float squared_distance, float sigma) {
    return gloam_gaussian_scaled(squared_distance, gloam_gaussian_scale(sigma));
}

// width of the filter in the world (TSSAO-10-sigma): `sigma = sigma_px 2 d tan(fov_y / 2) / H` [derived: world size of
// a pixel].
// Standard deviation in the world of a filter that is sigma_pixels wide in the image at a depth: sigma_px 2 d
// tan(fov_y / 2) / H.
// depth: eye-linear, world units. tan_half_fovy: tangent of half the vertical field of view. height: H, pixels.
// sigma_pixels: about a quarter of the filter's width (1.25 for 5 x 5). Orthographic: pass depth 1 and half the
// height of the view.
// Returns sigma in world units, in [0, FLT_MAX]; 0 for background depth, for any other argument that is not positive or
// NaN, and where infinite ones leave the quotient unknown.
// Error: 4 ULP.
float gloam_filter_sigma(float depth, float tan_half_fovy, float height, float sigma_pixels) {
    if (gloam_is_background(depth) || !(tan_half_fovy > 0.0 && height >= GLOAM_SMALLEST && sigma_pixels > 0.0))
        return 0.0;
    float sigma = 2.0 * tan_half_fovy * depth * (sigma_pixels / height);
    return sigma <= GLOAM_LARGEST ? sigma : (sigma > 0.0 ? GLOAM_LARGEST : 0.0);
}

#endif
