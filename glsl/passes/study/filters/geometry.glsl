// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_GEOMETRY_GLSL
#define GLOAM_FILTERS_GEOMETRY_GLSL

#include "gloam/filter/geometry_blur.glsl"

// The comparative study's blur (CS-BLUR): it weights by normal and depth, not by distance in the image. Reads
// filter_depth: the unit of depth, world units. In the study's scenes a radius had ten of these units.

// The study's exponents of the normal's and of the depth's weight.
const vec2 STUDY_POWERS = vec2(10.0, 0.5);

float gloam_fetch_occlusion(ivec2 pixel) {
    return source_at(pixel).occlusion;
}

float gloam_fetch_depth(ivec2 pixel) {
    return source_at(pixel).depth / parameters.filter_depth;
}

vec3 gloam_fetch_normal(ivec2 pixel) {
    return GLOAM_FETCH(normal_image, pixel).xyz;
}

float filtered_occlusion(ivec2 pixel) {
    return gloam_geometry_blur(pixel, filter_axis(), parameters.size, filter_half_width, STUDY_POWERS);
}

#endif
