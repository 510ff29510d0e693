// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_GEOMETRY_GLSL
#define GLOAM_FILTERS_GEOMETRY_GLSL

#include "gloam/filter/geometry_weight.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/background.glsl"

// The comparative study's blur (CS-BLUR): it weights by normal and depth, not by distance in the image. The function is
// gloam_geometry_blur over the row, with bit-identical results.
// Reads depth_scale: the unit of depth, world units. In the study's scenes a radius had ten of these units.

const int REACH = HALF_WIDTH;

// The study's exponents of the normal's and of the depth's weight.
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
    return Tap(source.occlusion, depth, !gloam_is_background(depth), GLOAM_FETCH(normal_image, pixel).xyz);
}

#include "passes/tiles/row.glsl"

// Mutual weight of two pixels. They are passed in the order of the row, so that the compiler can compute a pair once
// for both.
float weight_of(Tap first, Tap second) {
    return gloam_geometry_weight(first.normal, second.normal, first.depth - second.depth, STUDY_POWERS.x,
                                 STUDY_POWERS.y);
}

// mean: the sum so far. weight: of the tap if it has a surface. Returns the mean with the tap.
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
