// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_BILATERAL_GLSL
#define GLOAM_FILTER_BILATERAL_GLSL

#include "gloam/filter/weights.glsl"
#include "gloam/gather/fetch.glsl"

// bilateral smoothing of occlusion (ISSAO-7): `(1 / k) sum of f(xi) g(xi, x) s(dp(xi), dp(x)), k the sum of g s`
// [ISSAO, eq 7; Tomasi and Manduchi 1998].
// pixel: x, inside the image. half_width: pixels on each side, along x and y, at most 16. (h, h) is the window of the
// full bilateral filter (ISSAO-7); (h, 0) and (0, h) are the two passes of the usual approximation. size: of the image;
// neighbours outside are skipped. sigma_d, sigma_r: see gloam_bilateral_weight.
// Returns occlusion in [0, 1], between the smallest and the largest of the pixels used; background, and occlusion
// outside [0, 1] or NaN, have no weight. The pixel's own value (taken into [0, 1], 0 for NaN) where it is background.
// Error: 6e-7.
float gloam_bilateral_filter(ivec2 pixel, ivec2 half_width, ivec2 size, float sigma_d, float sigma_r) {
    float own = gloam_fetch_occlusion(pixel);
    float center = gloam_fetch_depth(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, own);
    ivec2 reach = clamp(half_width, ivec2(0), ivec2(16));
    for (int y = -reach.y; y <= reach.y; ++y) {
        for (int x = -reach.x; x <= reach.x; ++x) {
            ivec2 tap = pixel + ivec2(x, y);
            if (tap.x < 0 || tap.y < 0 || tap.x >= size.x || tap.y >= size.y) continue;
            float depth = gloam_fetch_depth(tap);
            float weight = gloam_bilateral_weight(vec2(x, y), depth - center, sigma_d, sigma_r);
            mean = gloam_weighted_mean_add(mean, gloam_fetch_occlusion(tap), gloam_is_background(depth) ? 0.0 : weight);
        }
    }
    return gloam_weighted_mean_value(mean, own);
}

#endif
