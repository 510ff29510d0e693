// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_SAO_GLSL
#define GLOAM_FILTERS_SAO_GLSL

#include "gloam/filter/sao_blur.glsl"
#include "gloam/filter/weighted_mean.glsl"

// The blur of scalable ambient obscurance (McGuire et al. 2012; CS-Q): at most four taps on each side, two pixels
// apart. The weight decreases linearly with the difference of depth and is 0 from depth_scale on.
// Reads depth_scale, world units. The paper uses 0.15 m: 300 m, the range of its depth key, divided by 2000. This
// filter compares the depth itself instead of the key.

const int SAO_STRIDE = 2;
const int SAO_MOST_TAPS = 4;
const int SAO_TAPS = min(HALF_WIDTH, SAO_MOST_TAPS);
const int REACH = SAO_STRIDE * SAO_TAPS;

#include "passes/tiles/depth_tap.glsl"
#include "passes/tiles/row.glsl"

// mean: the sum so far. center: depth of the filtered pixel, world units. number: of the tap, from the centre. Returns
// the mean with the tap; unchanged outside the image and for background.
GloamWeightedMean with_tap(GloamWeightedMean mean, float center, Tap tap, int number) {
    float weight = gloam_sao_blur_weight(number, (tap.depth - center) / parameters.depth_scale, 1.0);
    return gloam_weighted_mean_add(mean, tap.occlusion, tap.surface ? weight : 0.0);
}

float filtered_occlusion(int position) {
    Tap own = row_tap(position);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    UNROLL for (int i = -SAO_TAPS; i <= SAO_TAPS; ++i) mean =
        with_tap(mean, own.depth, row_tap(position + SAO_STRIDE * i), i);
    return gloam_weighted_mean_value(own.surface ? mean : gloam_weighted_mean_empty(), own.occlusion);
}

#endif
