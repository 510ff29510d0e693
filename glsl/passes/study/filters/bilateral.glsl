// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_BILATERAL_GLSL
#define GLOAM_FILTERS_BILATERAL_GLSL

#include "gloam/filter/bilateral.glsl"

// Weights by distance in the image and by difference of depth (ISSAO-7), with at most 16 taps on each side. Reads
// sigma_pixels (sigma_d) and filter_depth (sigma_r).

float gloam_fetch_occlusion(ivec2 pixel) {
    return source_at(pixel).occlusion;
}

float gloam_fetch_depth(ivec2 pixel) {
    return source_at(pixel).depth;
}

float filtered_occlusion(ivec2 pixel) {
    return gloam_bilateral_filter(pixel, filter_half_width * filter_axis(), parameters.size, parameters.sigma_pixels,
                                  parameters.filter_depth);
}

#endif
