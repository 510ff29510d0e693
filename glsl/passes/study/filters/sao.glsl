// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_SAO_GLSL
#define GLOAM_FILTERS_SAO_GLSL

#include "gloam/filter/weights.glsl"

// The blur of scalable ambient obscurance (McGuire et al. 2012; CS-Q): at most four taps on each side, two pixels
// apart. The weight decreases linearly with the difference of depth and is 0 from filter_depth on.
// Reads filter_depth, world units. The paper uses 0.15 m: 300 m, the range of its depth key, divided by 2000. This
// filter compares the depth itself instead of the key.

float filtered_occlusion(ivec2 pixel) {
    Source own = source_at(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    int taps = gloam_is_background(own.depth) ? -1 : min(filter_half_width, 4);
    for (int i = -taps; i <= taps; ++i) {
        ivec2 at = pixel + 2 * i * filter_axis();
        if (at.x < 0 || at.y < 0 || at.x >= parameters.size.x || at.y >= parameters.size.y) continue;
        Source tap = source_at(at);
        float weight = gloam_sao_blur_weight(i, (tap.depth - own.depth) / parameters.filter_depth, 1.0);
        mean = gloam_weighted_mean_add(mean, tap.occlusion, gloam_is_background(tap.depth) ? 0.0 : weight);
    }
    return gloam_weighted_mean_value(mean, own.occlusion);
}

#endif
