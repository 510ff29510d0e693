// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_GEOMETRY_GLSL
#define GLOAM_FILTERS_GEOMETRY_GLSL

#include "gloam/filter/geometry_blur.glsl"

// The comparative study's blur (CS-BLUR): neighbours count by their normal and their depth, however far they are in the image.
// Reads depth_scale: the unit of depth, of which the study's scenes had ten to a radius.

// Powers of normal and depth that the study used.
const vec2 STUDY_POWERS = vec2(10.0, 0.5);

float gloam_fetch_occlusion(ivec2 pixel) {
    return source_occlusion(pixel);
}

float gloam_fetch_depth(ivec2 pixel) {
    return imageLoad(depth_image, pixel).x / parameters.depth_scale;
}

vec3 gloam_fetch_normal(ivec2 pixel) {
    return imageLoad(normal_image, pixel).xyz;
}

// Occlusion of a pixel of the image, filtered along the axis: in [0, 1].
float filtered_occlusion(ivec2 pixel) {
    return gloam_geometry_blur(pixel, filter_axis(), parameters.size, parameters.half_width, STUDY_POWERS);
}

#endif
