// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_BILATERAL_GLSL
#define GLOAM_FILTERS_BILATERAL_GLSL

#include "gloam/filter/bilateral_weight.glsl"
#include "gloam/filter/weighted_mean.glsl"

// Weights by distance in the image and by difference of depth (ISSAO-7), with at most 16 taps on each side:
// gloam_bilateral_filter over the row, with bit-identical results. Reads sigma_pixels (sigma_d) and depth_scale
// (sigma_r).

const int REACH = min(HALF_WIDTH, 16);

#include "passes/tiles/depth_tap.glsl"
#include "passes/tiles/row.glsl"

// mean: the sum so far. center: depth of the filtered pixel. offset: of the tap from it, pixels. Returns the mean with
// the tap.
GloamWeightedMean with_tap(GloamWeightedMean mean, float center, Tap tap, int offset) {
    float weight = gloam_bilateral_weight(vec2(float(offset), 0.0), tap.depth - center, parameters.sigma_pixels,
                                          parameters.depth_scale);
    return gloam_weighted_mean_add(mean, tap.occlusion, tap.surface ? weight : 0.0);
}

float filtered_occlusion(int position) {
    Tap own = row_tap(position);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    UNROLL for (int i = -REACH; i <= REACH; ++i) mean = with_tap(mean, own.depth, row_tap(position + i), i);
    return gloam_weighted_mean_value(own.surface ? mean : gloam_weighted_mean_empty(), own.occlusion);
}

#endif
