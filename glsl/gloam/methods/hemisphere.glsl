// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HEMISPHERE_GLSL
#define GLOAM_METHODS_HEMISPHERE_GLSL

#include "gloam/gather/further_depths.glsl"
#include "gloam/gather/method.glsl"
#include "gloam/occlusion/crytek.glsl"
#include "gloam/occlusion/layers.glsl"

// Ambient occlusion by points in the half ball above the surface (TSSAO-2, -3 and -4 with the kernel of TSSAO-14;
// Ritschel et al. 2009). Directions are cosine-weighted and radii uniform, so samples need neither cosine nor
// falloff. The mean of the plain blocked tests estimates the occlusion integral (TSSAO-1) with the linear falloff,
// for a scene that is solid behind every visible surface.
struct GloamHemisphere {
    float range;  // world units, about the radius, or infinity: blockers further in front than this are other objects
    int layers;   // of depth that the points see, 1 to 4
};

// occlusion by points of the half ball (METHOD-hemisphere): `mean of V(p, s_i), s_i of TSSAO-14, i = j + 1 ... j + k`
// [TSSAO, eqs 2 to 4 and 14; Ritschel et al. 2009].
// All samples of one pixel in one frame, by points.
GloamEstimate gloam_hemisphere(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                               GloamHemisphere settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    mat3 frame = gloam_tangent_frame(normalize(normal));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec3 point = gloam_turn_hemisphere(gloam_hemisphere_cosine_point(kernel.first + i + 1u), turn);
        vec3 at = position + kernel.radius * (frame * point);
        if (point == vec3(0.0) || !(at.z < 0.0)) continue;
        ivec2 pixel = gloam_footprint_seen(footprint, at);
        float depth = gloam_footprint_plane_depth(footprint, pixel, at, frame[2]);
        float first = gloam_fetch_depth(pixel);
        if (gloam_tap_rejected(-position.z, first, kernel.farthest)) continue;
        vec3 further = gloam_further_depths(pixel, settings.layers);
        GloamLayersSeen layers = GloamLayersSeen(0.0, 0.0, true);
        for (int layer = 0; layer < settings.layers; ++layer) {
            float seen = gloam_layer_depth(first, further, layer);
            float blocked = gloam_sample_blocked(depth, seen, kernel.bias, settings.range) ? 1.0 : 0.0;
            layers = gloam_layers_add(layers, blocked, further, depth, layer, settings.layers);
        }
        sum += layers.occlusion;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

// StarCraft II's method (Filion and McNaughton 2008): points of the half ball, uniform in direction and radius. A
// surface further in front of a point than the radius blocks less, by radius / distance. Directions are uniform: a
// wall gives 1/2, as with cosine weights, and a bowl more.

// occlusion by uniform points of the half ball (METHOD-filion): `mean of min(R / (d - d_b), 1) where d_b < d` [Filion
// and McNaughton 2008, CS-B].
// All samples of one pixel in one frame, by points.
GloamEstimate gloam_filion(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    mat3 frame = gloam_tangent_frame(normalize(normal));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec3 point = gloam_turn_hemisphere(gloam_hemisphere_uniform_point(kernel.first + i + 1u), turn);
        vec3 at = position + kernel.radius * (frame * point);
        if (point == vec3(0.0) || !(at.z < 0.0)) continue;
        ivec2 pixel = gloam_footprint_seen(footprint, at);
        float depth = gloam_footprint_plane_depth(footprint, pixel, at, frame[2]);
        float seen = gloam_fetch_depth(pixel);
        if (gloam_tap_rejected(-position.z, seen, kernel.farthest)) continue;
        sum += gloam_contribution_filion(depth - kernel.bias, seen, kernel.radius);
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

// Crytek's method (Mittring 2007; CS-3.1): points of a whole ball, without falloff. On a plane half of the ball is
// below the surface. Points come in opposite pairs, so an even number of them gives exactly 1/2 on a bare plane, and
// a = 0.5 of the remap subtracts it. A point counts as open if it is behind the surface by less than the bias. With a
// bias of 0, opposite points of a plane differ.

// occlusion by points of a whole ball (METHOD-crytek): `mean of V(p, s_i), s_i and -s_i` [Mittring 2007, CS-3.1].
// All samples of one pixel in one frame, by points.
GloamEstimate gloam_crytek(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    mat3 frame = gloam_tangent_frame(normalize(normal));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        uint index = kernel.first + i + 1u;
        vec3 point = gloam_turn_hemisphere(gloam_hemisphere_uniform_point((index + 1u) / 2u), turn);
        if ((index & 1u) == 0u) point = -point;
        vec3 at = position + kernel.radius * (frame * point);
        if (point == vec3(0.0) || !(at.z < 0.0)) continue;
        ivec2 pixel = gloam_footprint_seen(footprint, at);
        float depth = gloam_footprint_plane_depth(footprint, pixel, at, frame[2]);
        float seen = gloam_fetch_depth(pixel);
        if (gloam_tap_rejected(-position.z, seen, kernel.farthest)) continue;
        sum += gloam_contribution_crytek(depth - kernel.bias, seen);
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
