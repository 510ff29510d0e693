// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ANGLE_GLSL
#define GLOAM_METHODS_ANGLE_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/gather/pair.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/occlusion/angle_based.glsl"

// Angles between opposite samples, as in Unreal Engine 4 (Mittring 2012; CS-P). The difference between the angle and
// half a turn is blocked. The result is neither cosine-weighted nor uniform.

struct GloamAngle {
    float range;       // world units: samples nearer to the eye than that are other objects
    float angle_bias;  // taken off the cosines
};

// what angles between opposite samples lack to half a turn (METHOD-angle): `mean of 1 - (acos c_1 + acos c_2) / pi`
// [Mittring 2012, CS-P].
// All samples of one pixel in one frame, in pairs.
GloamEstimate gloam_angle(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamAngle settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLinePoint point = gloam_line_point(position, n, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 tap = gloam_turn_disc(gloam_disc_point((kernel.first + i) / 2u + 1u).xy, turn);
        vec3 aim = vec3(kernel.radius * tap * point.upright, 0.0);
        float first = gloam_pair_height(point, tap, aim, kernel.radius);
        float second = gloam_pair_height(point, -tap, -aim, kernel.radius);
        vec3 cosines = gloam_angle_pair(aim + first * point.view, second * point.view - aim, n, point.view,
                                        settings.range);
        vec2 biased = clamp(cosines.xy - settings.angle_bias, -1.0, 1.0);
        vec2 sines = sqrt(max((1.0 - biased) * (1.0 + biased), GLOAM_LEAST_SQUARE));
        float angles = gloam_unit_angle(vec2(biased.x, sines.x)) + gloam_unit_angle(vec2(biased.y, sines.y));
        occluded += cosines.z * (1.0 - angles / GLOAM_PI);
        whole += cosines.z;
    }
    return gloam_estimate(occluded, whole, gloam_paired_samples(kernel.count));
}

#endif
