// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_GLSL
#define GLOAM_METHODS_VOLUMETRIC_GLSL

#include "gloam/gather/line_pair.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/sampling/disc_point.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/whole_samples.glsl"

// Volumetric obscurance by paired line samples (Loos and Sloan 2010; CS-3.5): the solid part of a ball around the
// point. A plane gives 1/2, and a = 0.5 of the remap subtracts it. A surface belongs to another object if it lies in
// front of the ball, or if it leaves less than 0.35 of its chord solid. Its sample counts as the opposite of its
// partner, so objects in front have no halo. But a one-sided groove of angle b gives 1/2 + sin(2 b) / (4 pi), 0.580
// at 45 degrees, instead of the ball's 1/2 + b / (2 pi).

// solid share of the ball around a pixel, by paired lines (CS-I-gather): `mean of q_i weighted by h_i` [volumetric
// obscurance (Loos and Sloan 2010), CS-3.5].
// All samples of one pixel in one frame (GloamEstimate); an odd number is taken as the even one above it.
GloamEstimate gloam_volumetric(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLinePoint point = gloam_line_point(position, n, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 tap = gloam_turn_disc(gloam_disc_point((kernel.first + i) / 2u + 1u).xy, turn);
        GloamPairShare pair = gloam_line_pair_share(point, tap, kernel);
        occluded += pair.occluded;
        whole += pair.whole;
    }
    return gloam_estimate(occluded, whole, gloam_paired_samples(kernel.count));
}

#endif
