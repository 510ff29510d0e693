// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_GLSL
#define GLOAM_METHODS_VOLUMETRIC_GLSL

#include "gloam/gather/footprint.glsl"
#include "gloam/gather/pair.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/volumetric.glsl"
#include "gloam/sampling/disc_point.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/whole_samples.glsl"

// Volumetric obscurance by paired line samples (Loos and Sloan 2010; CS-3.5): the solid share of a ball around the
// point. A plane reads 1/2, which the remap's a = 0.5 undoes. What lies in front of the ball, or so far behind that
// it leaves less than 0.35 of its chord solid, is another object's and counts by its opposite. So what stands in front
// has no halo. But a one-sided groove of angle b reads 1/2 + sin(2 b) / (4 pi), 0.580 at 45 degrees, instead of its
// ball's 1/2 + b / (2 pi).

// The surface at a chord is another object's below this share of the chord and beyond its near end, as the published
// shader has it.
const float GLOAM_LEAST_SOLID = 0.35;

// All samples of one pixel in one frame; an odd number is taken as the even one above it.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns the occlusion; outside the image the nearest pixel counts. No samples where there is nothing to gather
// (gloam_can_gather). Error: that of the contributions, but for taps within rounding of a pixel's border.
GloamEstimate gloam_volumetric(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec3 view = gloam_toward_eye(position, camera.orthographic);
    float facing = max(dot(view, n), 1e-4);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos(kernel.angle);
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
            float half_height = gloam_chord_half_height(tap, kernel.radius);
            vec2 ratios = vec2(gloam_line_ratio(first, half_height), gloam_line_ratio(second, half_height));
            vec2 solid = gloam_line_pair(ratios, GLOAM_LEAST_SOLID, 1.0);
            GloamPairShare found = GloamPairShare(half_height * (solid.x + solid.y), 2.0 * half_height);
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
