// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_PIXEL_SAMPLES_GLSL
#define GLOAM_PASSES_PIXEL_SAMPLES_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/radius_cap.glsl"
#include "gloam/occlusion/bias.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/sampling/count_by_distance.glsl"
#include "gloam/sampling/count_by_radius.glsl"
#include "gloam/sampling/hash_rotation.glsl"
#include "gloam/temporal/convergence.glsl"
#include "gloam/temporal/history.glsl"
#include "gloam/temporal/rotation_switch.glsl"
#include "gloam/temporal/sample_budget.glsl"

// What a pixel is sampled with in one frame, the same for ambient_occlusion.comp and for the passes that prepare for
// it: how many samples, from how far, turned by which angle. The user has a block `parameters` with the members that
// are read here, this_camera(), method_values, and the constants samples_asked, samples_converged, fewer_samples
// (read samples_distance, samples_radius and samples_least), caps_radius (read radius_cap), reject_taps, layers and
// ends_marches.

// Half-axes of the projected radius, pixels. depth: eye-linear, world units.
vec2 reach_at(float depth) {
    return gloam_camera_radius(parameters.radius, depth, this_camera()) * vec2(parameters.size);
}

// Radius of influence, world units: smaller where its projection would exceed the cap.
float radius_at(float depth) {
    if (!caps_radius) return parameters.radius;
    vec2 reach = reach_at(depth);
    float larger = max(reach.x, reach.y);
    if (!(larger > parameters.radius_cap)) return parameters.radius;
    vec2 capped = gloam_radius_cap(reach, parameters.radius_cap);
    return parameters.radius * (max(capped.x, capped.y) / larger);
}

// Samples that a pixel of that history is to take: k_1 or k_2 (TSSAO-AS), fewer far away (CS-N) and where the radius
// is small (ISSAO-LOD).
uint samples_at(GloamHistory before, float depth) {
    float convergence = gloam_convergence(before.weight, parameters.weight_max);
    // Where both are the same, a constant: loops that end by it are unrolled.
    int samples = int(samples_asked);
    if (samples_converged != samples_asked) {
        samples = gloam_sample_count(convergence, parameters.c_spatial, int(samples_asked), int(samples_converged));
    }
    if (!fewer_samples) return uint(samples);
    int least = min(int(parameters.samples_least), samples);
    if (parameters.samples_distance > 0.0)
        samples = gloam_count_by_distance(depth, parameters.samples_distance, samples, least);
    if (parameters.samples_radius > 0.0) {
        vec2 reach = reach_at(depth);
        samples = gloam_count_by_radius(max(reach.x, reach.y), parameters.samples_radius, least, samples);
    }
    return uint(samples);
}

// Those of a pixel. samples: of samples_at.
GloamKernel kernel_of(ivec2 pixel, float depth, GloamHistory before, uint samples) {
    float convergence = gloam_convergence(before.weight, parameters.weight_max);
    float angle =
        gloam_rotation_enabled(convergence, parameters.c_rot) ? gloam_hash_rotation(pixel - parameters.border) : 0.0;
    float bias = max(parameters.bias, gloam_depth_bias(parameters.bias_depth, depth, 1.0));
    float farthest = reject_taps ? method_values.range : uintBitsToFloat(0x7F800000u);
    return GloamKernel(radius_at(depth), bias, angle, before.index, samples, farthest, layers, ends_marches);
}

#endif
