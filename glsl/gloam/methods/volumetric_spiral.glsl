// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_SPIRAL_GLSL
#define GLOAM_METHODS_VOLUMETRIC_SPIRAL_GLSL

#include "gloam/gather/line_pair.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/sampling/radical_inverse.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/spiral.glsl"
#include "gloam/sampling/whole_samples.glsl"

// Paired line samples on a spiral (Toy Story 3: The Video Game; Ownby, Hall and Hall 2010; CS-R): the ball of
// volumetric, with its pairs on a spiral that is rotated from pixel to pixel and from frame to frame. Where both
// samples of a pair are invalid, both count 1/2. Radii are uniform, so a pair is weighted by its radius as well as
// its chord.

const int GLOAM_LINE_SPIRAL_TURNS = 7;

// (cos, sin) of the rotation of the spiral: of the pixel's angle and the frame's. Half a turn moves each tap to its
// partner.
vec2 gloam_line_spiral_turn(GloamKernel kernel) {
    uint frame = kernel.first / max(gloam_paired_samples(kernel.count), 1u);
    return gloam_sincos_turns(gloam_turns(kernel.angle) + 0.5 * gloam_radical_inverse_base2(frame));
}

// All samples of one pixel in one frame; an odd number is taken as the even one above it. Parameters and result are
// those of gloam_volumetric.
GloamEstimate gloam_volumetric_spiral(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLinePoint point = gloam_line_point(position, n, kernel.radius, camera);
    vec2 turn = gloam_line_spiral_turn(kernel);
    uint pairs = gloam_paired_samples(kernel.count) / 2u;
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < pairs; ++i) {
        vec2 tap = gloam_spiral_point(int(i), int(pairs), GLOAM_LINE_SPIRAL_TURNS);
        GloamPairShare pair = gloam_line_pair_share(point, gloam_turn_disc(tap, turn), kernel);
        float density = float(2u * i + 1u);  // of the disc's area for each tap
        occluded += density * pair.occluded;
        whole += density * pair.whole;
    }
    return gloam_estimate(occluded, whole, 2u * pairs);
}

#endif
