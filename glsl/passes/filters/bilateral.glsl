// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_BILATERAL_GLSL
#define GLOAM_FILTERS_BILATERAL_GLSL

#include "gloam/filter/bilateral.glsl"

// Neighbours count by distance in the image and difference of depth (ISSAO-7), at most 16 on each side.
// Reads sigma_pixels (sigma_d) and depth_scale (sigma_r).

float gloam_fetch_occlusion(ivec2 pixel) {
    return source_occlusion(pixel);
}

float gloam_fetch_depth(ivec2 pixel) {
    return imageLoad(depth_image, pixel).x;
}

// Occlusion of a pixel of the image, filtered along the axis: in [0, 1].
float filtered_occlusion(ivec2 pixel) {
    return gloam_bilateral_filter(pixel, parameters.half_width * filter_axis(), parameters.size, parameters.sigma_pixels,
                                  parameters.depth_scale);
}

#endif
