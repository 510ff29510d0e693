// SPDX-License-Identifier: MIT
// passes/study/ambient_occlusion.comp as a fragment shader, for surfaces that stand still, one depth layer, without tiles:
// the samples of one frame, blended into the history. METHOD is the call of a method, whose file is included before
// this one.
#include "gloam/geometry/camera.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/sampling/whole_samples.glsl"
#include "gloam/temporal/blend.glsl"
#include "gloam/temporal/convergence.glsl"
#include "gloam/temporal/history.glsl"
#include "gloam/temporal/smoothing.glsl"
#include "passes/study/method_values.glsl"

// Those of passes/study/ambient_occlusion.comp, with the same meaning.
struct Parameters {
    vec2 p00_p11;
    ivec2 size;
    ivec2 border;
    float radius;
    float bias;
    float c_spatial;
    float weight_max;
    float c_rot;
    float least_radius;
    float samples_distance;
    float samples_radius;
    uint samples_least;
    float radius_cap;
    float smoothing;
    float bias_depth;
};
uniform Parameters parameters;
uniform MethodValues method_values;
uniform uint samples_asked;
uniform uint samples_converged;
uniform uint samples_unit;
uniform bool rounds_up;
uniform uint table_size;
uniform bool reject_taps;
uniform bool on_lattice;
layout(constant_id = 0) const bool orthographic = false;  // the camera; else perspective
const bool fewer_samples = true;
const bool caps_radius = true;

uniform sampler2D depth_image;     // eye-linear depth; background 0
uniform sampler2D normal_image;    // view-space normal that faces the eye
uniform sampler2D history_before;  // (occlusion, samples accumulated, samples of the sequence used, depth)

layout(location = 0) out vec4 history_after;

GloamCamera this_camera() {
    return GloamCamera(parameters.p00_p11, parameters.size, orthographic);
}

#include "passes/study/pixel_samples.glsl"

float gloam_fetch_depth(ivec2 pixel) {
    return texelFetch(depth_image, pixel, 0).x;
}

vec3 gloam_fetch_layers(ivec2 pixel) {
    return vec3(0.0);
}

vec3 gloam_fetch_normal(ivec2 pixel) {
    return texelFetch(normal_image, pixel, 0).xyz;
}

GloamEstimate estimated(ivec2 pixel, float depth, GloamHistory before, uint samples) {
    GloamCamera camera = this_camera();
    GloamKernel kernel = kernel_of(pixel, depth, before, samples);
    vec3 position = gloam_camera_position(pixel, depth, camera);
    vec3 normal = gloam_fetch_normal(pixel);
    MethodValues values = method_values;
    values.layers = 1;
    return METHOD(position, normal, camera, kernel, values);
}

// Whole units of the method.
uint samples_for(GloamHistory before, float depth) {
    uint samples = samples_at(before, depth);
    if (samples == 0u) return 0u;
    return gloam_whole_samples(rounds_up ? samples + samples_unit - 1u : samples, samples_unit);
}

GloamHistory sampled(ivec2 pixel, float depth) {
    GloamHistory before = gloam_history_unpack(texelFetch(history_before, pixel, 0));
    uint samples = samples_for(before, depth);
    GloamEstimate fresh = GLOAM_NO_ESTIMATE;
    if (samples > 0u) fresh = estimated(pixel, depth, before, samples);
    vec2 blended = gloam_blend(before.occlusion, before.weight, fresh.occlusion, fresh.samples * fresh.weight,
                               parameters.weight_max);
    if (parameters.smoothing > 0.0 && fresh.samples > 0.0) {
        blended.x =
            gloam_temporal_smooth(before.occlusion, before.weight > 0.0, fresh.occlusion, parameters.smoothing);
    }
    return GloamHistory(blended.x, blended.y, gloam_next_index(before.index, samples, table_size), depth);
}

GloamHistory shade(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    if (gloam_is_background(depth)) return gloam_history_empty(depth);
    vec2 reach = reach_at(depth);
    if (max(reach.x, reach.y) < parameters.least_radius) {
        return GloamHistory(0.0, parameters.weight_max, 0u, depth);  // known for certain: converged
    }
    return sampled(pixel, depth);
}

void main() {
    history_after = gloam_history_pack(shade(ivec2(gl_FragCoord.xy)));
}
