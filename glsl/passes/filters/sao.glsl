// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_SAO_GLSL
#define GLOAM_FILTERS_SAO_GLSL

#include "gloam/filter/sao_blur.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/background.glsl"

// The blur of scalable ambient obscurance (McGuire et al. 2012; CS-Q): at most four taps on each side, two pixels apart; one counts nothing from
// depth_scale on, and linearly more before it.
// Reads depth_scale: in print 0.15 m, the depth key's 300 m over 2000. The depth itself is at hand and stands for the key.

const int SAO_STRIDE = 2;
const int SAO_MOST_TAPS = 4;

// mean: what was added so far. tap: its number, from the centre. center: depth of the filtered pixel, world units.
// Returns the mean with the tap; unchanged outside the image and for background.
GloamWeightedMean add_tap(GloamWeightedMean mean, ivec2 pixel, int tap, float center) {
    ivec2 at = pixel + SAO_STRIDE * tap * filter_axis();
    if (at.x < 0 || at.y < 0 || at.x >= parameters.size.x || at.y >= parameters.size.y) return mean;
    float depth = imageLoad(depth_image, at).x;
    if (gloam_is_background(depth)) return mean;
    float weight = gloam_sao_blur_weight(tap, (depth - center) / parameters.depth_scale, 1.0);
    return gloam_weighted_mean_add(mean, source_occlusion(at), weight);
}

// Occlusion of a pixel of the image, filtered along the axis: in [0, 1].
float filtered_occlusion(ivec2 pixel) {
    float own = source_occlusion(pixel);
    float center = imageLoad(depth_image, pixel).x;
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, own);
    int last = min(parameters.half_width, SAO_MOST_TAPS);
    for (int tap = -last; tap <= last; ++tap) mean = add_tap(mean, pixel, tap, center);
    return gloam_weighted_mean_value(mean, own);
}

#endif
