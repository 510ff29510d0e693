// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_GEOMETRY_GLSL
#define GLOAM_FILTERS_GEOMETRY_GLSL

#include "gloam/filter/geometry_weight.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/background.glsl"

// The comparative study's blur (CS-BLUR): neighbours count by their normal and their depth, however far they are in the image;
// gloam_geometry_blur over the row, to the bit.
// Reads depth_scale: the unit of depth, of which the study's scenes had ten to a radius.

const int REACH = HALF_WIDTH;

// Powers of normal and depth that the study used.
const vec2 STUDY_POWERS = vec2(10.0, 0.5);

struct Tap {
    float occlusion;
    float depth;  // units of depth_scale
    bool surface;
    vec3 normal;
};

Tap weightless(Tap tap) {
    return Tap(tap.occlusion, tap.depth, false, tap.normal);
}

Tap tap_at(ivec2 pixel) {
    Source source = source_at(pixel);
    float depth = source.depth / parameters.depth_scale;
    return Tap(source.occlusion, depth, !gloam_is_background(depth), imageLoad(normal_image, pixel).xyz);
}

#include "passes/tiles/row.glsl"

// mean: what was added so far. own: the filtered pixel.
GloamWeightedMean with_tap(GloamWeightedMean mean, Tap own, Tap tap) {
    float weight = gloam_geometry_weight(own.normal, tap.normal, own.depth - tap.depth, STUDY_POWERS.x, STUDY_POWERS.y);
    return gloam_weighted_mean_add(mean, tap.occlusion, tap.surface ? weight : 0.0);
}

float filtered_occlusion(int position) {
    Tap own = row_tap(position);
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own.occlusion, 1.0);
    UNROLL for (int i = 1; i <= HALF_WIDTH; ++i) {
        mean = with_tap(mean, own, row_tap(position - i));
        mean = with_tap(mean, own, row_tap(position + i));
    }
    return gloam_weighted_mean_value(own.surface ? mean : gloam_weighted_mean_empty(), own.occlusion);
}

#endif
