// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_CONVERGENCE_FILTER_GLSL
#define GLOAM_FILTER_CONVERGENCE_FILTER_GLSL

#include "gloam/filter/weights.glsl"

// Smoothing of occlusion that trusts each neighbour as far as it has converged (TSSAO-10), along one axis of the
// image: run it along x, then along y on the result (not quite the same as in two dimensions, since the weights do
// not separate). The result is for display: fed back into the history it would blur more with every frame.

// Defined by the user: (occlusion, convergence) of a pixel inside the image, each in [0, 1].
vec2 gloam_fetch_occlusion_convergence(ivec2 pixel);

// Defined by the user: position of the surface under a pixel inside the image, world units, view space; the zero
// vector, or one with an infinite or NaN component, for background.
vec3 gloam_fetch_position(ivec2 pixel);

// smoothing that trusts neighbours as far as they have converged (TSSAO-10): `AO = (1/K) sum of g(|p - x|) conv(x)
// AO(x), K = sum of g(|p - x|) conv(x)` [TSSAO, eqs 10 and 11].
// Of one pixel along one axis, over the window shrunk by gloam_shrink of the pixel's own convergence.
// pixel: inside the image. axis: (1, 0) or (0, 1). size: image size in pixels; neighbours outside are left out.
// half_width: pixels on each side at full width, 2 for 5 x 5; negative counts as 0. c_adaptive: see gloam_shrink, 0.2.
// sigma: world units, see gloam_filter_sigma.
// Returns occlusion in [0, 1], between the smallest and the largest of the pixels used. The pixel's own value (taken
// into [0, 1], 0 for NaN) where the window has shrunk to nothing (no neighbour is read), at background, and where K <
// 1e-8: nothing near has converged. Error: 8e-7.
float gloam_convergence_filter(ivec2 pixel, ivec2 axis, ivec2 size, int half_width, float c_adaptive, float sigma) {
    vec2 own = gloam_fetch_occlusion_convergence(pixel);
    float reach = float(max(half_width, 0)) * gloam_shrink(own.y, c_adaptive);
    if (!(reach > 0.0)) return gloam_unit_interval(own.x);
    vec3 center = gloam_fetch_position(pixel);
    if (!(center.z < 0.0)) return gloam_unit_interval(own.x);
    float scale = gloam_gaussian_scale(sigma);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    int last = 2 * min(half_width, max(size.x, size.y)) + 1;
    for (int i = 1; i <= last && float(i >> 1) < reach + 1.0; ++i) {
        ivec2 tap = pixel + ((i & 1) == 0 ? -(i >> 1) : i >> 1) * axis;
        if (tap.x < 0 || tap.y < 0 || tap.x >= size.x || tap.y >= size.y) continue;
        vec3 position = gloam_fetch_position(tap);
        vec2 value = gloam_fetch_occlusion_convergence(tap);
        float coverage = i == 1 ? 1.0 : gloam_window_coverage(i >> 1, reach);
        float weight = gloam_convergence_weight(position - center, coverage, scale, gloam_unit_interval(value.y));
        mean = gloam_weighted_mean_add(mean, value.x, position.z < 0.0 ? weight : 0.0);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

#endif
