// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_PIXEL_SAMPLES_GLSL
#define GLOAM_PASSES_PIXEL_SAMPLES_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/occlusion/blocked.glsl"
#include "gloam/sampling/count.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/temporal/blend.glsl"
#include "gloam/temporal/history.glsl"

// The samples of a pixel in one frame: their number, their radius and their rotation. ambient_occlusion.comp and the
// preparation passes include this file, so that they agree.
// Both have the parameters below; before it they declare a buffer with the MethodValues `method_values`.

layout(constant_id = 2) const int layers = 1;               // of depth that the samples see, 1 to 4
// leave out taps further in front than MethodValues::range (CS-REJ)
layout(constant_id = 3) const bool reject_taps = false;
layout(constant_id = 6) const bool fewer_samples = true;    // read samples_distance, samples_radius and samples_least
layout(constant_id = 7) const bool caps_radius = true;      // read radius_cap
layout(constant_id = 9) const bool orthographic = false;    // the camera; else perspective
layout(constant_id = 14) const bool keeps_history = true;   // else each frame stands by itself
layout(constant_id = 21) const bool on_lattice = false;    // kernels are rotated on a lattice; else by a hash
// Numbers that loops end by: compilers unroll those whose length they know.
layout(constant_id = 15) const uint samples_asked = 32u;      // k_1, for each pixel that has not converged
layout(constant_id = 16) const uint samples_converged = 16u;  // k_2, for each pixel that has
layout(constant_id = 17) const uint method_steps = 4u;        // in the place of MethodValues::steps

layout(push_constant) uniform Parameters {
    vec2 p00_p11;          // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;            // of the images, pixels, with the guard band
    ivec2 border;          // guard band on each side, pixels (TSSAO-BORDER): samples read it; 0 for none
    float radius;          // of influence, world units
    float bias;            // world units
    float c_spatial;       // convergence from which a pixel takes k_2; above 1 never
    float weight_max;      // w_max: samples in the mean, at most
    float c_rot;           // kernels are rotated below this convergence; 0 never
    float least_radius;    // pixels: where the projected radius is smaller, occlusion is 0 without a sample; 0 never
    uint shade_border;     // 1: the band has occlusion as well, a history for what moves in; 0: it is left out
    uint invalidation;     // where a neighbourhood changed: 0 nothing, 1 at most weight_small samples count, 2 by
                           // confidence
    float change_tolerance;  // change of a distance that is taken for rounding, world units
    float weight_small;    // invalidation 1: samples
    float confidence_factor;  // invalidation 2: S, per radius of change
    float samples_distance;  // of the far plane, world units: fewer samples the further away (CS-N); 0: as many
                             // everywhere
    float samples_radius;    // pixels: fewer samples where the projected radius is smaller (ISSAO-LOD); 0: as many
                             // everywhere
    uint samples_least;    // of those, at least
    float radius_cap;      // pixels: the projected radius is at most that large (Gears of War 2)
    float smoothing;       // part of a frame in an exponential mean (CS-G); 0: the mean of TSSAO-5
    float bias_depth;      // the bias is at least this share of the depth
#ifdef GLOAM_PREPARATION_PASS_GLSL
    int level;             // that the pass writes, 1 for half the resolution; of passes that run once for each level
#endif
} parameters;

GloamCamera this_camera() {
    return GloamCamera(parameters.p00_p11, parameters.size, orthographic);
}

// Half-axes of the projected radius, pixels. depth: eye-linear, world units.
vec2 reach_at(float depth) {
    return gloam_camera_radius(parameters.radius, depth, this_camera()) * vec2(parameters.size);
}

// Whether a surface at that depth is open without a sample, because its projected radius is below the limit.
bool below_limit(float depth) {
    vec2 reach = reach_at(depth);
    return max(reach.x, reach.y) < parameters.least_radius;
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
