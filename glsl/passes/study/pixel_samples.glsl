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
#include "gloam/sampling/lattice_rotation.glsl"
#include "gloam/temporal/convergence.glsl"
#include "gloam/temporal/history.glsl"
#include "gloam/temporal/rotation_switch.glsl"
#include "gloam/temporal/sample_budget.glsl"

// The samples of a pixel in one frame: their number, their radius and their rotation. ambient_occlusion.comp and the
// preparation passes include this file, so that they agree.
// The user defines a block `parameters` with the members that this file reads, this_camera() and method_values. The
// user's constants are samples_asked, samples_converged, fewer_samples (which makes it read samples_distance,
// samples_radius and samples_least), caps_radius (radius_cap), on_lattice and reject_taps.

// Half-axes of the projected radius, pixels. depth: eye-linear, world units.
vec2 reach_at(float depth) {
    return gloam_camera_radius(parameters.radius, depth, this_camera()) * vec2(parameters.size);
}

// Radius of influence at a depth, world units: smaller where its projection would exceed the cap.
float radius_at(float depth) {
    if (!caps_radius) return parameters.radius;
    vec2 reach = reach_at(depth);
    float larger = max(reach.x, reach.y);
    if (!(larger > parameters.radius_cap)) return parameters.radius;
    vec2 capped = gloam_radius_cap(reach, parameters.radius_cap);
    return parameters.radius * (max(capped.x, capped.y) / larger);
}

// Samples that a pixel with this history takes: k_1 or k_2 (TSSAO-AS), fewer far away (CS-N) and where the radius is
// small (ISSAO-LOD).
uint samples_at(GloamHistory before, float depth) {
    float convergence = gloam_convergence(before.weight, parameters.weight_max);
    // If k_1 equals k_2, the number is a constant, so that the compiler can unroll the loops over samples.
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

// Another angle for each pixel, radians.
float rotation_of(ivec2 pixel) {
    return on_lattice ? gloam_lattice_rotation(pixel) : gloam_hash_rotation(pixel);
}

// The kernel of a pixel. samples: as samples_at returns it.
GloamKernel kernel_of(ivec2 pixel, float depth, GloamHistory before, uint samples) {
    float convergence = gloam_convergence(before.weight, parameters.weight_max);
    float angle =
        gloam_rotation_enabled(convergence, parameters.c_rot) ? rotation_of(pixel - parameters.border) : 0.0;
    float bias = max(parameters.bias, gloam_depth_bias(parameters.bias_depth, depth, 1.0));
    float farthest = reject_taps ? method_values.range : uintBitsToFloat(0x7F800000u);
    return GloamKernel(radius_at(depth), bias, angle, before.index, samples, farthest);
}

#endif
