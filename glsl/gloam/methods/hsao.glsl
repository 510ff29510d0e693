// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HSAO_GLSL
#define GLOAM_METHODS_HSAO_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/into_slice.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/layers.glsl"
#include "gloam/sampling/slice_sample.glsl"
#include "gloam/sampling/whole_samples.glsl"

// Horizon-split ambient occlusion (Dimitrov, Bavoil and Sainz 2008; CS-C2), the precursor of hbao. The horizons are
// the same, but they come from rays marched in eye space, parallel to the image, in steps of equal length. Each step
// is projected. Two opposite rays are one slice. With the same taps the result is that of hbao, up to intensities
// that bring a single slice above 1.
struct GloamHsao {
    float angle_bias;  // radians above the tangent plane below which nothing blocks
    float contrast;    // factor of the result
    uint steps;        // of a ray, at least 1
};

// All samples of one pixel in one frame (GloamEstimate). Steps lie evenly up to the radius; background, the point's own
// pixel and steps that are not in front of the eye do not count. Error: that of the rays, but for taps within rounding
// of a pixel's border.
GloamEstimate gloam_hsao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamHsao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    float turns = gloam_turns(kernel.angle);
    vec2 bias = gloam_sincos_turns(gloam_turns(settings.angle_bias));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    uint steps = max(settings.steps, 1u);
    uint rays = gloam_whole_samples(kernel.count, steps) / steps;
    float occluded = 0.0;
    for (uint i = 0u; i < rays; ++i) {
        uint index = kernel.first / steps + i;
        GloamSliceSample random = gloam_slice_sample(index / 2u + 1u, turns);
        vec3 direction = vec3((index & 1u) == 1u ? -random.direction : random.direction, 0.0);
        vec3 axis = vec3(direction.y, -direction.x, 0.0);
        float jitter = random.jitter;
        float horizon = gloam_hbao_horizon(n, direction.xy, bias).y;
        float found = 0.0;
        for (uint k = 0u; k < steps && horizon < 1.0; ++k) {
            vec3 at = position + kernel.radius * ((float(k) + jitter) / float(steps)) * direction;
            ivec2 pixel = gloam_footprint_seen(footprint, at);
            float first = gloam_fetch_depth(pixel);
            vec3 further = kernel.layers > 1 ? gloam_fetch_layers(pixel) : vec3(0.0);
            if (!(at.z < 0.0) || pixel == footprint.pixel) continue;
            for (int layer = 0; layer < kernel.layers; ++layer) {
                float depth = gloam_layer_depth(first, further, layer);
                vec3 seen = gloam_footprint_position(footprint, pixel, depth) - position;
                vec3 offset = gloam_into_slice(seen, axis, n);
                float squared = dot(offset, offset);
                float weight = 1.0 - squared / (kernel.radius * kernel.radius);
                float sine = min(offset.z * inversesqrt(max(squared, 1e-36)), 1.0);
                bool counts = gloam_tap_sees(depth) && weight > 0.0 && dot(seen, n) > kernel.bias && sine > horizon;
                found += counts ? (sine - horizon) * weight : 0.0;
                horizon = counts ? sine : horizon;
            }
        }
        occluded += found;
    }
    // The mean over the rays is that of the horizons: what the bias took off it is given back once.
    GloamEstimate estimate = gloam_estimate(occluded, float(rays), rays * steps);
    estimate.occlusion = 1.0 - gloam_hbao_visibility(estimate.occlusion, settings.angle_bias, settings.contrast);
    return estimate;
}

#endif
