// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_UNREAL_GLSL
#define GLOAM_METHODS_UNREAL_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/angle_based.glsl"

// The later shader of Unreal Engine 4 (CS-P). Along both sides of mirrored directions of the image it takes the
// largest sat(epsilon (v . n) / (v . v)) of the steps. A side leaves (1 - occ)^2 open, and the result is the mean
// over sides. Near surfaces count more than high ones: on the line of a groove, its rising side is blocked except in
// the line's own direction. The engine's power is c of the remap.
struct GloamUnreal {
    float epsilon;    // world units: distance up to which a blocker straight above counts fully, 0.8 in the engine
    float intensity;  // of the result, at most 1
    uint steps;       // of a side, at least 1
};

// what blocks most on each of the rays along the image (METHOD-unreal): `intensity times the mean of 1 - (1 - max of
// C(v_k))^2` [a later shader of Unreal Engine 4].
// All samples of one pixel in one frame, by rays.
GloamEstimate gloam_unreal(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamUnreal settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    float turns = gloam_turns(kernel.angle);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    uint steps = max(settings.steps, 1u);
    uint rays = gloam_whole_samples(kernel.count, steps) / steps;
    float occluded = 0.0;
    for (uint i = 0u; i < rays; ++i) {
        uint index = kernel.first / steps + i;
        GloamSliceSample random = gloam_slice_sample(index / 2u + 1u, turns);
        vec3 direction = vec3((index & 1u) == 1u ? -random.direction : random.direction, 0.0);
        float jitter = random.jitter;
        float most = 0.0;
        for (uint k = 0u; k < steps && most < 1.0; ++k) {
            vec3 at = gloam_eye_march(position, direction, kernel.radius, k, steps, jitter);
            ivec2 pixel = gloam_footprint_seen(footprint, at);
            float depth = gloam_fetch_depth(pixel);
            if (pixel == footprint.pixel) continue;
            vec3 offset = gloam_footprint_position(footprint, pixel, depth) - position;
            float counted = gloam_contribution_unreal(offset, n, kernel.bias, settings.epsilon);
            most = gloam_tap_sees(depth) ? max(most, counted) : most;
        }
        occluded += 1.0 - gloam_unreal_side(most);
    }
    GloamEstimate estimate = gloam_estimate(occluded, float(rays), rays * steps);
    estimate.occlusion = 1.0 - gloam_unreal_visibility(1.0 - estimate.occlusion, 1.0, min(settings.intensity, 1.0));
    return estimate;
}

#endif
