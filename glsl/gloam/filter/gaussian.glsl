// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_GAUSSIAN_GLSL
#define GLOAM_FILTER_GAUSSIAN_GLSL

#include "gloam/geometry/background.glsl"

// Weight of a neighbour by its distance in the world (g of TSSAO-10): exp(-d^2 / (2 sigma^2)). Depth edges need no further term.
// squared_distance: d^2, world units squared, >= 0 (below 0 it is read as 0). sigma: world units, >= 0.
// Returns a weight in [0, 1], not below 1e-30 unless 0. For sigma zero, subnormal or negative: 1 at distance 0, else 0. An infinite
// distance gives 0, an infinite sigma 1 at every finite one, NaN in either 0. Error: 3e-7; 1e-6 by any device that keeps
// Vulkan's rules for exp() and division.
float gloam_gaussian(float squared_distance, float sigma) {
    float d2 = squared_distance > 0.0 ? squared_distance : 0.0;
    if (!(squared_distance <= 3.402823466e38) || !(abs(sigma) >= 0.0)) return 0.0;
    if (sigma > 3.402823466e38) return 1.0;
    if (!(sigma >= 1.175494351e-38)) return d2 > 0.0 ? 0.0 : 1.0;
    // Divided twice, because the square of sigma may overflow or underflow.
    float x = 0.5 * (d2 / sigma) / sigma;
    return x <= 69.0 ? min(exp(-x), 1.0) : 0.0;
}

// Standard deviation in the world of a filter that is sigma_pixels wide in the image at a depth: sigma_px 2 d tan(fov_y / 2) / H.
// depth: eye-linear, world units. tan_half_fovy: tangent of half the vertical field of view. height: H, pixels.
// sigma_pixels: about a quarter of the filter's width (1.25 for 5 x 5). Orthographic: pass depth 1 and half the height of the view.
// Returns sigma in world units, in [0, FLT_MAX]; 0 for background depth and for any other argument that is not positive or NaN.
// Error: 2.5 ULP.
float gloam_filter_sigma(float depth, float tan_half_fovy, float height, float sigma_pixels) {
    if (gloam_is_background(depth) || !(tan_half_fovy > 0.0 && height >= 1.175494351e-38 && sigma_pixels > 0.0)) return 0.0;
    float sigma = 2.0 * tan_half_fovy * depth * (sigma_pixels / height);
    return sigma <= 3.402823466e38 ? sigma : (sigma > 0.0 ? 3.402823466e38 : 0.0);
}

#endif
