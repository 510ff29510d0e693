// SPDX-License-Identifier: MIT
#version 450
// Ambient occlusion of one frame, blended into the history (TSSAO-2 to -6, -12 to -14, BUF, ROT). The history is that
// of the same pixel: move it first (reproject.comp) where the view has changed. Where objects move, the samples tell as
// well whether the neighbourhood of the pixel has changed, and the history then counts less (TSSAO-9, -SI).
//
// Define METHOD, and change the include, for another method than the one below.
// Define GLOAM_PREPARED as r32f for a method whose prepared image has one channel (separable, sao_chain), else it is
// rgba32f.
#include "passes/study/input_image.glsl"
#ifndef GLOAM_PREPARED
#define GLOAM_PREPARED rgba32f
#endif

layout(constant_id = 1) const bool watches_objects = false;  // watch the neighbourhood through binding 4
layout(constant_id = 5) const uint table_size = 65536u;     // samples after which the sequence starts over
layout(constant_id = 8) const bool smooths = true;          // read smoothing
layout(constant_id = 20) const bool shows_alone = false;    // neither history nor filter: only binding 8 is written
layout(constant_id = 18) const uint samples_unit = 1u;  // samples are taken in whole units of so many, at least one
layout(constant_id = 19) const bool rounds_up = false;        // to the next whole unit; else down

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
// History before and after: (occlusion, samples accumulated, samples of the sequence used, depth); zeros for none,
// background (0, 0, 0, infinity). Read when keeps_history is set, written unless shows_alone is set.
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT history_before;
layout(binding = 3, rgba32f) uniform writeonly highp image2D history_after;
// Where each surface point was, in the view space of the previous frame; read when watches_objects is set.
layout(binding = 4 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT previous_position_image;

#include "gloam/geometry/pixel.glsl"
#include "gloam/sampling/count.glsl"
#include "gloam/temporal/blend.glsl"
#include "gloam/temporal/invalidation.glsl"
#include "method_values.glsl"

// Depth layers 1 to 3 behind depth_image, in xyz: eye-linear, negative where seen from behind, 0 or not finite where
// there is none; read when layers is more than 1.
layout(binding = 7 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT layer_image;
layout(binding = 5, std430) readonly buffer MethodSettings { MethodValues method_values; };
layout(binding = 6 GLOAM_FORMAT(GLOAM_PREPARED)) uniform GLOAM_INPUT prepared_image;  // of preparation/pass.glsl
layout(binding = 8, r32f) uniform writeonly highp image2D shown_image;  // occlusion, when shows_alone is set

#include "pixel_samples.glsl"

// The method, any file of that folder, and its call; values: a MethodValues.
#include "gloam/methods/hemisphere.glsl"
#ifndef METHOD
#define METHOD(position, normal, camera, kernel, values) \
    gloam_hemisphere(position, normal, camera, kernel, GloamHemisphere(values.range, values.layers))
#endif

// The point being shaded, where it was, and what the samples have shown of its neighbourhood so far.
struct Neighborhood {
    vec3 position;
    vec3 previous;  // in the view space of the previous frame
    vec3 normal;
    float reach;   // how far what blocks a sample may be, world units
    float change;  // largest, world units
};
Neighborhood neighborhood;

// Takes the surface point under a sample as a probe (TSSAO-9). The ray is divided as gloam_footprint_ray divides, so
// that compilers share it.
void probe(ivec2 pixel, float depth) {
    vec2 ray = (vec2(2 * pixel + 1) - vec2(parameters.size)) / vec2(parameters.size) / parameters.p00_p11;
    vec3 now = vec3(orthographic ? ray : ray * depth, -depth) - neighborhood.position;
    vec3 before = GLOAM_FETCH(previous_position_image, pixel).xyz - neighborhood.previous;
    float change = gloam_probe_change(now, before, neighborhood.normal, neighborhood.reach);
    float largest = max(neighborhood.change, change);  // outside of the choice, so that it is no branch
    neighborhood.change = gloam_tap_sees(depth) ? largest : neighborhood.change;
}

// Read by the samples, which thereby are the probes.
float gloam_fetch_depth(ivec2 pixel) {
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    if (watches_objects) probe(pixel, depth);
    return depth;
}

// Read by the samples where they see more layers than the first.
vec3 gloam_fetch_layers(ivec2 pixel) {
    return GLOAM_FETCH(layer_image, pixel).xyz;
}

// Read by methods that prepare something.
vec4 gloam_fetch_prepared(ivec2 pixel) {
    return GLOAM_FETCH(prepared_image, pixel);
}

// Read by the methods that look at the surface under a sample.
vec3 gloam_fetch_normal(ivec2 pixel) {
    return GLOAM_FETCH(normal_image, pixel).xyz;
}

// A sample is as far as the radius from the point, and what blocks it up to `range` in front of the sample.
Neighborhood neighborhood_of(ivec2 pixel, vec3 position, vec3 normal, float radius) {
    vec3 previous = GLOAM_FETCH(previous_position_image, pixel).xyz;
    return Neighborhood(position, previous, normal, radius + method_values.range, 0.0);
}

// What the method says of a pixel by `samples` samples.
GloamEstimate estimated(ivec2 pixel, float depth, GloamHistory before, uint samples) {
    GloamCamera camera = this_camera();
    GloamKernel kernel = kernel_of(pixel, depth, before, samples);
    vec3 position = gloam_camera_position(pixel, depth, camera);
    vec3 normal = GLOAM_FETCH(normal_image, pixel).xyz;
    if (watches_objects) neighborhood = neighborhood_of(pixel, position, normal, kernel.radius);
    MethodValues values = method_values;
    values.steps = method_steps;
    values.layers = layers;
    return METHOD(position, normal, camera, kernel, values);
}

// How many samples a pixel takes: whole units of the method. A constant where k_1 is k_2, so that loops are unrolled.
uint samples_for(GloamHistory before, float depth) {
    uint samples = samples_at(before, depth);
    if (fewer_samples && samples == 0u) return 0u;
    return gloam_whole_samples(rounds_up ? samples + samples_unit - 1u : samples, samples_unit);
}

GloamHistory sampled(ivec2 pixel, float depth) {
    GloamHistory before = gloam_history_empty(depth);
    if (keeps_history) before = gloam_history_unpack(GLOAM_FETCH(history_before, pixel));
    uint samples = samples_for(before, depth);
    GloamEstimate fresh = GloamEstimate(0.0, 0.0, 1.0);
    float change = 0.0;  // of a pixel that takes no sample nothing is known
    if (samples > 0u) {
        fresh = estimated(pixel, depth, before, samples);
        change = neighborhood.change;
    }
    float weight = before.weight;
    if (watches_objects)
        weight = gloam_invalidated_weight(weight, change, parameters.radius, parameters.invalidation,
                                          parameters.change_tolerance, parameters.weight_small,
                                          parameters.confidence_factor);
    vec2 blended =
        gloam_blend(before.occlusion, weight, fresh.occlusion, fresh.samples * fresh.weight, parameters.weight_max);
    if (smooths && parameters.smoothing > 0.0 && fresh.samples > 0.0) {
        blended.x = gloam_temporal_smooth(before.occlusion, weight > 0.0, fresh.occlusion, parameters.smoothing);
    }
    return GloamHistory(blended.x, blended.y, gloam_next_index(before.index, samples, table_size), depth);
}

bool left_out(ivec2 pixel) {
    if (parameters.shade_border != 0u) return false;
    ivec2 inner = pixel - parameters.border;
    return inner != gloam_clamp_to_edge(inner, parameters.size - 2 * parameters.border);
}

GloamHistory shade(ivec2 pixel) {
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    if (left_out(pixel) || gloam_is_background(depth)) return gloam_history_empty(depth);
    if (below_limit(depth)) return GloamHistory(0.0, parameters.weight_max, 0u, depth);  // known for certain: converged
    return sampled(pixel, depth);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    GloamHistory after = shade(pixel);
    if (shows_alone) {
        imageStore(shown_image, pixel, vec4(gloam_history_sanitize(after).occlusion));
    } else {
        imageStore(history_after, pixel, gloam_history_pack(after));
    }
}
