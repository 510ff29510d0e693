// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_GEOMETRY_BLUR_GLSL
#define GLOAM_FILTER_GEOMETRY_BLUR_GLSL

#include "gloam/filter/weights.glsl"
#include "gloam/gather/fetch.glsl"

// Blur that keeps to a surface (CS-BLUR), along one axis of the image: run it along x, then along y on the result.
// The study uses it for all its methods, from 1 pixel on either side upward.

// geometry-aware blur along one axis (CS-BLUR): `(1 / K) sum of w AO, K the sum of w` [Aalund and Baerentzen 2013,
// geometry-aware blur].
// pixel: inside the image. axis: (1, 0) or (0, 1). size: image size in pixels; neighbours outside are left out.
// half_width: pixels on each side, at most 64; negative counts as 0. powers: (p_n, p_z) of gloam_geometry_weight,
// (10, 0.5).
// Returns occlusion in [0, 1], between the smallest and the largest of the pixels used; the pixel itself has weight
// 1. Its own value (taken into [0, 1], 0 for NaN) where it is background. Error: 1e-6.
float gloam_geometry_blur(ivec2 pixel, ivec2 axis, ivec2 size, int half_width, vec2 powers) {
    float own = gloam_fetch_occlusion(pixel);
    float center = gloam_fetch_depth(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, own);
    vec3 normal = gloam_fetch_normal(pixel);
    mean = gloam_weighted_mean_add(mean, own, 1.0);
    int last = min(half_width, 64);
    for (int i = 2; i <= 2 * last + 1; ++i) {
        ivec2 tap = pixel + ((i & 1) == 0 ? -(i >> 1) : i >> 1) * axis;
        if (tap.x < 0 || tap.y < 0 || tap.x >= size.x || tap.y >= size.y) continue;
        float depth = gloam_fetch_depth(tap);
        float weight = gloam_geometry_weight(normal, gloam_fetch_normal(tap), center - depth, powers.x, powers.y);
        mean = gloam_weighted_mean_add(mean, gloam_fetch_occlusion(tap), gloam_is_background(depth) ? 0.0 : weight);
    }
    return gloam_weighted_mean_value(mean, own);
}

#endif
