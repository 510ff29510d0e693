// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DUAL_RESOLUTION_GLSL
#define GLOAM_METHODS_DUAL_RESOLUTION_GLSL

#include "gloam/filter/dual_resolution.glsl"
#include "gloam/filter/resolution.glsl"
#include "gloam/filter/weights.glsl"
#include "gloam/gather/further_depths.glsl"
#include "gloam/methods/hbao.glsl"
#include "gloam/occlusion/layers.glsl"

// Horizon-based occlusion in two resolutions (Bavoil and Sainz 2009). It is computed at half the resolution first
// (preparation/half_resolution.comp). It is computed in full where the 3 x 3 neighbourhood of the small image differs
// too much, or where none of it lies on the pixel's surface. Elsewhere the small image is interpolated along the
// surface.
struct GloamDualResolution {
    float angle_bias;    // these three as hbao has them, at both resolutions
    float contrast;
    uint steps;
    float disagreement;  // of neighbours at half the resolution, in occlusion, beyond which a pixel is sampled in full
    int layers;          // of depth that both see, 1 to 4
};

// Read by gloam_dual_resolution_disagrees.
float gloam_fetch_occlusion(ivec2 pixel) {
    return gloam_fetch_prepared(pixel).x;
}

// Height over the tangent plane, as a fraction of the radius, at which a small pixel counts a quarter.
const float GLOAM_DUAL_HEIGHT = 0.02;
const float GLOAM_DUAL_HEIGHT_POWER = 2.0;
const float GLOAM_DUAL_NORMAL_POWER = 8.0;
// Sum of weights, of 1, below which the small image says too little about the pixel.
const float GLOAM_DUAL_LEAST_WEIGHT = 0.25;

// The interpolated small image with one of its pixels added. share: weight by position, [0, 1].
GloamWeightedMean gloam_dual_add(GloamWeightedMean mean, ivec2 small, float share, vec3 position, vec3 normal,
                                 GloamFootprint footprint, float radius) {
    if (!(share > 0.0)) return mean;
    ivec2 source = gloam_half_source(small);
    float depth = gloam_fetch_depth(source);
    if (!gloam_tap_sees(depth)) return mean;
    vec4 texel = gloam_fetch_prepared(small);
    vec3 offset = gloam_footprint_position(footprint, source, depth) - position;
    float height = dot(offset, normal) / (GLOAM_DUAL_HEIGHT * radius);
    vec3 facing = gloam_safe_normalize(texel.yzw, vec3(0.0));
    float weight = gloam_mssao_upsample_weight(share, height, dot(facing, normal), GLOAM_DUAL_HEIGHT_POWER,
                                               GLOAM_DUAL_NORMAL_POWER);
    return gloam_weighted_mean_add(mean, texel.x, weight);
}

// The small image at the footprint's pixel: the mean of those of the four small pixels around it that lie on its
// surface. Where the pixel is that of a small one, only that one.
GloamWeightedMean gloam_dual_interpolated(vec3 position, vec3 normal, GloamFootprint footprint, float radius) {
    ivec2 first = footprint.pixel / 2;
    ivec2 last = min(first + 1, gloam_half_size(ivec2(footprint.size)) - 1);
    vec2 along = 0.5 * vec2(footprint.pixel - gloam_half_source(first));
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    vec2 share = 1.0 - along;
    mean = gloam_dual_add(mean, first, share.x * share.y, position, normal, footprint, radius);
    mean = gloam_dual_add(mean, ivec2(last.x, first.y), along.x * share.y, position, normal, footprint, radius);
    mean = gloam_dual_add(mean, ivec2(first.x, last.y), share.x * along.y, position, normal, footprint, radius);
    return gloam_dual_add(mean, last, along.x * along.y, position, normal, footprint, radius);
}

// Horizons over all layers: all samples of one pixel in one frame (GloamEstimate), with one layer those of gloam_hbao.
GloamEstimate gloam_dual_horizons(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                  GloamDualResolution settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    uint steps = max(settings.steps, 1u);
    uint slices = gloam_whole_samples(kernel.count, 2u * steps) / (2u * steps);
    vec2 bias = gloam_sincos_turns(gloam_turns(settings.angle_bias));
    float sum = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        GloamSliceSample random = gloam_slice_sample(kernel.first / (2u * steps) + i + 1u, turns);
        vec2 direction = random.direction * gloam_upright(camera);
        GloamSliceAxes axes = gloam_slice_axes(gloam_slice(direction, vec3(0.0, 0.0, 1.0), n), n);
        vec2 march = vec2(0.0);
        for (int side = 0; side < 2; ++side) {
            float towards = side == 0 ? 1.0 : -1.0;
            march.x = gloam_hbao_horizon(n, towards * direction, bias).y;
            for (uint k = 0u; k < steps; ++k) {
                float share = (float(k) + random.jitter) / float(steps);
                ivec2 at = gloam_footprint_pixel(footprint, towards * share * share * random.direction);
                float first = gloam_fetch_depth(at);
                vec3 further = gloam_further_depths(at, settings.layers);
                for (int layer = 0; layer < settings.layers; ++layer) {
                    float depth = gloam_layer_depth(first, further, layer);
                    march = gloam_hbao_tap(march, footprint, at, depth, position, n, axes, kernel);
                }
            }
        }
        sum += 1.0 - gloam_hbao_visibility(0.5 * march.y, settings.angle_bias, settings.contrast);
    }
    return gloam_estimate(sum, float(slices), slices * 2u * steps);
}

// hbao from half the resolution where that agrees (METHOD-dual_resolution): `the small image interpolated, or
// gloam_hbao over all layers` [Bavoil and Sainz 2009, CS-E].
// All samples of one pixel in one frame; where the small image is taken, those of its pixels. gloam_fetch_prepared:
// (occlusion, normal) of the small image. position: under a pixel's centre. Error: that of gloam_hbao, or 3e-6 of the
// weights.
GloamEstimate gloam_dual_resolution(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                    GloamDualResolution settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    if (!gloam_dual_resolution_disagrees(footprint.pixel / 2, gloam_half_size(camera.size), settings.disagreement)) {
        GloamWeightedMean mean = gloam_dual_interpolated(position, normalize(normal), footprint, kernel.radius);
        uint samples = gloam_whole_samples(kernel.count, 2u * max(settings.steps, 1u));
        if (mean.weight >= GLOAM_DUAL_LEAST_WEIGHT)
            return GloamEstimate(gloam_weighted_mean_value(mean, 0.0), float(samples), 1.0);
    }
    return gloam_dual_horizons(position, normal, camera, kernel, settings);
}

#endif
