// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_GLSL
#define GLOAM_METHODS_VOLUMETRIC_GLSL

#include "gloam/occlusion/pair_gather.glsl"
#include "gloam/occlusion/volumetric.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_paired_samples(count)

// Volumetric obscurance by paired line samples (Loos and Sloan 2010; CS-3.5): the solid share of a ball around the point. A plane reads 1/2, which
// the remap's a = 0.5 undoes. What lies in front of the ball, or so far behind that it leaves less than 0.35 of its chord solid, is another
// object's and counts by its opposite: what stands in front has no halo, but a one-sided groove of angle b reads 1/2 + sin(2 b) / (4 pi), 0.580
// at 45 degrees, for the 1/2 + b / (2 pi) of its ball.

// The surface at a chord is another object's below this share of the chord and beyond its near end, as the published shader has it.
const float GLOAM_LEAST_SOLID = 0.35;

vec2 gloam_method_pair_occlusion(GloamPair pair, GloamKernel kernel, GloamMethod method) {
    float half_height = gloam_chord_half_height(pair.point, kernel.radius);
    float first = gloam_line_ratio(pair.heights.x, half_height);
    float second = gloam_line_ratio(pair.heights.y, half_height);
    vec2 solid = gloam_line_pair(vec2(first, second), GLOAM_LEAST_SOLID, 1.0);
    return half_height * vec2(solid.x + solid.y, 2.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_pair_gather(position, normal, camera, kernel, method);
}

#endif
