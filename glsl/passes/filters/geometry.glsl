// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_GEOMETRY_GLSL
#define GLOAM_FILTERS_GEOMETRY_GLSL

#include "gloam/filter/geometry_weight.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/background.glsl"

// The comparative study's blur (CS-BLUR): neighbours count by their normal and their depth, however far they are in
// the image; gloam_geometry_blur over the row, to the bit.
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

// Weight of two pixels for each other, in the order of the row: then that of a pair is computed once for both.
float weight_of(Tap first, Tap second) {
    return gloam_geometry_weight(first.normal, second.normal, first.depth - second.depth, STUDY_POWERS.x,
                                 STUDY_POWERS.y);
}

// mean: what was added so far. weight: of the tap, as on a surface.
GloamWeightedMean with_tap(GloamWeightedMean mean, Tap tap, float weight) {
    return gloam_weighted_mean_add(mean, tap.occlusion, tap.surface ? weight : 0.0);
}

float filtered_occlusion(int position) {
    Tap own = row_tap(position);
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own.occlusion, 1.0);
    UNROLL for (int i = 1; i <= HALF_WIDTH; ++i) {
        Tap before = row_tap(position - i);
        Tap after = row_tap(position + i);
        mean = with_tap(mean, before, weight_of(before, own));
        mean = with_tap(mean, after, weight_of(own, after));
    }
    return gloam_weighted_mean_value(own.surface ? mean : gloam_weighted_mean_empty(), own.occlusion);
}

#endif
