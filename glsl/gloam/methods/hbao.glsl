// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HBAO_GLSL
#define GLOAM_METHODS_HBAO_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/slice.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/layers.glsl"
#include "gloam/sampling/slice_sample.glsl"
#include "gloam/sampling/whole_samples.glsl"

// Horizon-based ambient occlusion (Bavoil and Sainz 2008; CS-3.2 to 3.4): horizons above the image plane. Every
// direction of the hemisphere counts the same, and each rise of the horizon is weighted by 1 - |v|^2 / R^2. Steps are
// dense nearby, and a gain makes up for what the bias takes off.
struct GloamHbao {
    float angle_bias;  // radians above the tangent plane below which nothing blocks
    float contrast;    // factor of the result
    uint steps;        // taps along each half of a slice, at least 1
};

// All samples of one pixel in one frame (GloamEstimate). Error: 4e-6, 6e-5 where a slice nearly lies in the tangent
// plane, but for taps within rounding of a pixel's border.
GloamEstimate gloam_hbao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamHbao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    uint steps = max(settings.steps, 1u);
    uint slices = gloam_whole_samples(kernel.count, 2u * steps) / (2u * steps);
    vec2 bias = gloam_sincos_turns(gloam_turns(settings.angle_bias));
    uint left_out = 0u;
    float sum = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        GloamSliceSample random = gloam_slice_sample(kernel.first / (2u * steps) + i + 1u, turns);
        vec2 direction = random.direction * gloam_upright(camera);
        GloamSlice slice = gloam_slice(direction, vec3(0.0, 0.0, 1.0), n);
        GloamSliceAxes axes = gloam_slice_axes(slice, n);
        float found = 0.0;
        for (int side = 0; side < 2; ++side) {
            float towards = side == 0 ? 1.0 : -1.0;
            float horizon = gloam_hbao_horizon(n, towards * direction, bias).y;
            // Nothing rises above the bias where the tangent plane slopes towards the eye nearly along the view: the
            // sine there is 1.
            uint taps = kernel.ends_marches && !(horizon < 1.0) ? 0u : steps;
            left_out += steps - taps;
            for (uint k = 0u; k < taps; ++k) {
                float share = (float(k) + random.jitter) / float(steps);
                ivec2 at = gloam_footprint_pixel(footprint, towards * share * share * random.direction);
                float first = gloam_fetch_depth(at);
                vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);
                for (int layer = 0; layer < kernel.layers; ++layer) {
                    float depth = gloam_layer_depth(first, further, layer);
                    vec3 seen = gloam_footprint_position(footprint, at, depth) - position;
                    vec2 offset = vec2(dot(seen, axes.view), dot(seen, axes.tangent));
                    float squared = dot(offset, offset);
                    float weight = 1.0 - squared / (kernel.radius * kernel.radius);
                    float sine = min(offset.x * inversesqrt(max(squared, 1e-36)), 1.0);
                    bool counts = depth > 0.0 && weight > 0.0 && at != footprint.pixel && dot(seen, n) > kernel.bias &&
                                  sine > horizon && !gloam_tap_rejected(-position.z, depth, kernel.farthest);
                    found += counts ? (sine - horizon) * weight : 0.0;
                    horizon = counts ? sine : horizon;
                }
            }
        }
        sum += 1.0 - gloam_hbao_visibility(0.5 * found, settings.angle_bias, settings.contrast);
    }
    GloamEstimate estimate = gloam_estimate(sum, float(slices), slices * 2u * steps);
    estimate.left_out = left_out;
    return estimate;
}

#endif
