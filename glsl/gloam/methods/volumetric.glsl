// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_GLSL
#define GLOAM_METHODS_VOLUMETRIC_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/gather/pair.glsl"

// Volumetric obscurance by paired line samples (Loos and Sloan 2010; CS-3.5): the solid part of a ball around the
// point. A plane gives 1/2, and a = 0.5 of the remap subtracts it. A surface belongs to another object if it lies in
// front of the ball, or if it leaves less than 0.35 of its chord solid. Its sample counts as the opposite of its
// partner, so objects in front have no halo. But a one-sided groove of angle b gives 1/2 + sin(2 b) / (4 pi), 0.580
// at 45 degrees, instead of the ball's 1/2 + b / (2 pi).

// solid share of the ball around a pixel, by paired lines (METHOD-volumetric): `mean of q_i weighted by h_i` [Loos and
// Sloan 2010, CS-3.5].
// All samples of one pixel in one frame, in pairs.
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

// volumetric at two radii (Loos and Sloan 2010). Half of the samples are in a ball of a quarter of the radius, for
// fine detail, and half in the whole ball. The amounts by which both exceed a plane's 1/2 are added. (The larger of
// the two would depend on the noise of a frame's few samples.)

// volumetric in two balls (METHOD-volumetric_two): `1/2 + (VO(R / 4) - 1/2) + (VO(R) - 1/2)` [Loos and Sloan 2010,
// CS-I].
// All samples of one pixel in one frame, as many at both radii: whole fours, at least one. Parameters and result are
// those of gloam_volumetric.
GloamEstimate gloam_volumetric_two(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    GloamKernel broad = kernel;
    broad.first = kernel.first / 2u;
    broad.count = gloam_whole_samples(kernel.count, 4u) / 2u;  // by pairs at both radii
    GloamKernel fine = broad;
    fine.radius = 0.25 * kernel.radius;
    GloamEstimate far = gloam_volumetric(position, normal, camera, broad);
    GloamEstimate near = gloam_volumetric(position, normal, camera, fine);
    if (!(far.samples > 0.0)) return GLOAM_NO_ESTIMATE;
    return GloamEstimate(gloam_two_balls(near.occlusion, far.occlusion), float(2u * broad.count), 1.0);
}

// Paired line samples on a spiral (Toy Story 3: The Video Game; Ownby, Hall and Hall 2010; CS-I): the ball of
// volumetric, with its pairs on a spiral that is rotated from pixel to pixel and from frame to frame. Where both
// samples of a pair are invalid, both count 1/2. Radii are uniform, so a pair is weighted by its radius as well as
// its chord.

// (cos, sin) of the rotation of the spiral: of the pixel's angle and the frame's. Half a turn moves each tap to its
// partner.
vec2 gloam_line_spiral_turn(GloamKernel kernel) {
    uint frame = kernel.first / max(gloam_paired_samples(kernel.count), 1u);
    return gloam_sincos_turns(gloam_turns(kernel.angle) + 0.5 * gloam_radical_inverse_base2(frame));
}

// volumetric by pairs on a spiral (METHOD-volumetric_spiral): `mean of q_i weighted by h_i rho_i` [Ownby, Hall and Hall
// 2010, CS-I].
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
        vec2 tap = gloam_spiral_point(int(i), int(pairs), 7);
        GloamPairShare pair = gloam_line_pair_share(point, gloam_turn_disc(tap, turn), kernel);
        float density = float(2u * i + 1u);  // of the disc's area for each tap
        occluded += density * pair.occluded;
        whole += density * pair.whole;
    }
    return gloam_estimate(occluded, whole, 2u * pairs);
}

// Volumetric obscurance of the ball of half the radius that touches the surface from outside (Szirmay-Kalos et al.
// 2009). A plane leaves it empty. Chords lie along the view vector. Along the axis of a perspective view, a floor
// seen from a camera that looks up would lie in front of its own ball.

// solid share of the ball that touches the surface (METHOD-tangent_sphere): `mean of q_i weighted by h_i`
// [Szirmay-Kalos et al. 2009].
// All samples of one pixel in one frame, in pairs.
GloamEstimate gloam_tangent_sphere(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLinePoint point = gloam_line_point(position, n, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    mat3 toward_eye = gloam_tangent_frame(point.view);  // its third column the view vector
    vec3 facing_eye = n * toward_eye;
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 tap = gloam_turn_disc(gloam_disc_point((kernel.first + i) / 2u + 1u).xy, turn);
        vec3 aim = vec3(kernel.radius * tap * point.upright, 0.0);
        float first = gloam_pair_height(point, tap, aim, kernel.radius);
        float second = gloam_pair_height(point, -tap, -aim, kernel.radius);
        // Turned before the heights are added: a far background would round the place of the chord.
        vec3 one = aim * toward_eye + vec3(0.0, 0.0, first);
        vec3 other = vec3(0.0, 0.0, second) - aim * toward_eye;
        float one_chord = gloam_tangent_sphere_half_height(one, facing_eye, kernel.radius);
        float other_chord = gloam_tangent_sphere_half_height(other, facing_eye, kernel.radius);
        float solid = one_chord * gloam_tangent_sphere_occlusion(one, facing_eye, kernel.radius) +
                      other_chord * gloam_tangent_sphere_occlusion(other, facing_eye, kernel.radius);
        occluded += solid;
        whole += one_chord + other_chord;
    }
    return gloam_estimate(occluded, whole, gloam_paired_samples(kernel.count));
}

#endif
