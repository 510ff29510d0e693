// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_TANGENT_SPHERE_GLSL
#define GLOAM_METHODS_TANGENT_SPHERE_GLSL

#include "gloam/gather/footprint.glsl"
#include "gloam/gather/pair.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/volumetric.glsl"
#include "gloam/sampling/disc_point.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/tangent_frame.glsl"
#include "gloam/sampling/whole_samples.glsl"

// Volumetric obscurance of the ball of half the radius that touches the surface from outside (Szirmay-Kalos et al.
// 2009). A plane leaves it empty. Chords lie along the view vector. Along the axis of a perspective view, a floor
// seen from a camera that looks up would lie in front of its own ball.

// All samples of one pixel in one frame (GloamEstimate); an odd number is taken as the even one above it.
GloamEstimate gloam_tangent_sphere(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    vec3 view = gloam_toward_eye(position, camera.orthographic);
    float facing = max(dot(view, n), 1e-4);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    mat3 toward_eye = gloam_tangent_frame(view);  // its third column the view vector
    vec3 facing_eye = n * toward_eye;
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 tap = gloam_turn_disc(gloam_disc_point((kernel.first + i) / 2u + 1u).xy, turn);
        vec3 aim = vec3(kernel.radius * tap * gloam_upright(camera), 0.0);
        GloamPairDepths depths = gloam_pair_depths(footprint, tap, kernel.layers);
        GloamPairShare most = GloamPairShare(0.0, 0.0);
        vec2 stayed = vec2(0.0);
        for (int look = 0; look < 2 * kernel.layers - 1; ++look) {
            vec2 looked = gloam_pair_look(depths, stayed, look, kernel.layers);
            float first =
                gloam_pair_height(footprint, depths.first_pixel, looked.x, aim, position, n, facing, kernel.radius);
            float second =
                gloam_pair_height(footprint, depths.second_pixel, looked.y, -aim, position, n, facing, kernel.radius);
            vec3 one = (aim + first * view) * toward_eye;
            vec3 other = (second * view - aim) * toward_eye;
            float one_chord = gloam_tangent_sphere_half_height(one, facing_eye, kernel.radius);
            float other_chord = gloam_tangent_sphere_half_height(other, facing_eye, kernel.radius);
            float solid = one_chord * gloam_tangent_sphere_occlusion(one, facing_eye, kernel.radius) +
                          other_chord * gloam_tangent_sphere_occlusion(other, facing_eye, kernel.radius);
            GloamPairShare found = GloamPairShare(solid, one_chord + other_chord);
            if (!gloam_pair_stays(looked, look, kernel.layers, found, most)) continue;
            most = found;
            stayed = looked;
        }
        occluded += most.occluded;
        whole += most.whole;
    }
    return gloam_estimate(occluded, whole, gloam_paired_samples(kernel.count));
}

#endif
