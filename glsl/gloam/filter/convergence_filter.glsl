// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_CONVERGENCE_FILTER_GLSL
#define GLOAM_FILTER_CONVERGENCE_FILTER_GLSL

#include "gloam/filter/gaussian.glsl"
#include "gloam/filter/shrink.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/surface_position.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Smoothing of occlusion that trusts each neighbour as far as it has converged (TSSAO-10), along one axis of the
// image: run it along x, then along y on the result (not quite the same as in two dimensions, since the weights do
// not separate). The result is for display: fed back into the history it would blur more with every frame.

// Defined by the user: (occlusion, convergence) of a pixel inside the image, each in [0, 1].
vec2 gloam_fetch_occlusion_convergence(ivec2 pixel);

// Defined by the user: position of the surface under a pixel inside the image, world units, in view space or centred
// on the camera; the zero vector, or one with an infinite or NaN component, for background.
vec3 gloam_fetch_position(ivec2 pixel);

// one neighbour in the filter's mean (TSSAO-10-tap): `(sum + w AO, K + w), w = coverage g(|p - x|) conv(x)` [TSSAO
// (Mattausch et al.), eq 10].
// Adds the pixel at a tap.
// mean: what was added so far. center: position of the filtered pixel, world units. tap: pixel inside the image.
// coverage: part of the tap in the window, [0, 1]; below 1e-30 it may count as 0. scale: of gloam_gaussian_scale, 1 /
// world units.
// Returns the mean with the tap's occlusion, weighted by coverage, distance and convergence (read inside [0, 1], NaN
// as 0). Unchanged for background and for occlusion outside [0, 1]. Error: 5e-7 of the tap.
// No method or pass here calls it: it is there to be copied.
GloamWeightedMean gloam_filter_tap(GloamWeightedMean mean, vec3 center, ivec2 tap, float coverage, float scale) {
    vec3 position = gloam_fetch_position(tap);
    vec2 value = gloam_fetch_occlusion_convergence(tap);
    if (!gloam_is_surface_position(position)) return mean;
    vec3 offset = position - center;
    float weight = coverage * gloam_gaussian_scaled(dot(offset, offset), scale) * gloam_unit_interval(value.y);
    return gloam_weighted_mean_add(mean, value.x, weight);
}

// smoothing that trusts neighbours as far as they have converged (TSSAO-10): `AO = (1/K) sum of g(|p - x|) conv(x)
// AO(x), K = sum of g(|p - x|) conv(x)` [TSSAO (Mattausch et al.), eqs 10 and 11].
// Filtered occlusion of one pixel along one axis (TSSAO-10 and -11): (1 / K) sum of g(|p - x|) conv(x) AO(x) over the
// window, K = sum of g(|p - x|) conv(x), the window shrunk by gloam_shrink of the pixel's own convergence.
// pixel: inside the image. axis: (1, 0) or (0, 1). size: image size in pixels; neighbours outside are left out.
// half_width: pixels on each side at full width, 2 for 5 x 5; negative counts as 0. c_adaptive: see gloam_shrink, 0.2.
// sigma: world units, see gloam_filter_sigma.
// Returns occlusion in [0, 1], between the smallest and the largest of the pixels used. The pixel's own value (taken
// into [0, 1], 0 for NaN) where the window has shrunk to nothing (no neighbour is read), at background, and where K <
// 1e-8: nothing near has converged.
// Error: 8e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_convergence_filter(ivec2 pixel, ivec2 axis, ivec2 size, int half_width, float c_adaptive, float sigma) {
    vec2 own = gloam_fetch_occlusion_convergence(pixel);
    float reach = float(max(half_width, 0)) * gloam_shrink(own.y, c_adaptive);
    if (!(reach > 0.0)) return gloam_unit_interval(own.x);
    vec3 center = gloam_fetch_position(pixel);
    if (!gloam_is_surface_position(center)) return gloam_unit_interval(own.x);
    float scale = gloam_gaussian_scale(sigma);
    GloamWeightedMean mean = gloam_filter_tap(gloam_weighted_mean_empty(), center, pixel, 1.0, scale);
    int last = min(half_width, max(size.x, size.y));
    for (int i = 1; i <= last && float(i) < reach + 1.0; ++i) {
        float coverage = gloam_window_coverage(i, reach);
        ivec2 before = pixel - i * axis;
        ivec2 after = pixel + i * axis;
        if (before.x >= 0 && before.y >= 0) mean = gloam_filter_tap(mean, center, before, coverage, scale);
        if (after.x < size.x && after.y < size.y) mean = gloam_filter_tap(mean, center, after, coverage, scale);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

#endif
