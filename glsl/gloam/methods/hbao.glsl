// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HBAO_GLSL
#define GLOAM_METHODS_HBAO_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/geometry/slice.glsl"
#include "gloam/occlusion/hbao.glsl"

// Horizon-based ambient occlusion (Bavoil and Sainz 2008; CS-3.2 to 3.4): horizons above the image plane. Every
// direction of the hemisphere counts the same, and each rise of the horizon is weighted by 1 - |v|^2 / R^2. Steps are
// dense nearby, and a gain makes up for what the bias takes off.
struct GloamHbao {
    float angle_bias;  // radians above the tangent plane below which nothing blocks
    float contrast;    // factor of the result
    uint steps;        // taps along each half of a slice, at least 1
};

// A march of a slice after one more tap: (sine of the horizon, occlusion found).
// at: pixel of the tap. depth: there. normal: of the shaded point, unit.
vec2 gloam_hbao_tap(vec2 march, GloamFootprint footprint, ivec2 at, float depth, vec3 position, vec3 normal,
                    GloamSliceAxes axes, GloamKernel kernel) {
    vec3 seen = gloam_footprint_position(footprint, at, depth) - position;
    vec2 offset = vec2(dot(seen, axes.view), dot(seen, axes.tangent));
    vec2 stepped = gloam_hbao_step(march, offset.x, dot(offset, offset), kernel.radius);
    bool counts = depth > 0.0 && at != footprint.pixel && dot(seen, normal) > kernel.bias &&
                  !gloam_tap_rejected(-position.z, depth, kernel.farthest);
    return counts ? stepped : march;
}

// occlusion by horizons above the image plane (METHOD-hbao): `mean of the sum of W(v_k) (sin h_k - sin h_(k-1)), over
// what the bias leaves` [Bavoil and Sainz 2008, CS-3.2 to 3.4].
// Error: 4e-6, 6e-5 where a slice nearly lies in the tangent plane, but for taps within rounding of a pixel's border.
GloamEstimate gloam_hbao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamHbao settings) {
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
        GloamSlice slice = gloam_slice(direction, vec3(0.0, 0.0, 1.0), n);
        GloamSliceAxes axes = gloam_slice_axes(slice, n);
        vec2 march = vec2(0.0);  // sine of the horizon, occlusion found
        for (int side = 0; side < 2; ++side) {
            float towards = side == 0 ? 1.0 : -1.0;
            march.x = gloam_hbao_horizon(n, towards * direction, bias).y;
            for (uint k = 0u; k < steps; ++k) {
                float share = (float(k) + random.jitter) / float(steps);
                ivec2 at = gloam_footprint_pixel(footprint, towards * share * share * random.direction);
                float depth = gloam_fetch_depth(at);
                march = gloam_hbao_tap(march, footprint, at, depth, position, n, axes, kernel);
            }
        }
        sum += 1.0 - gloam_hbao_visibility(0.5 * march.y, settings.angle_bias, settings.contrast);
    }
    return gloam_estimate(sum, float(slices), slices * 2u * steps);
}

// Horizon-based ambient occlusion as in the comparative study (Aalund and Baerentzen 2013, after Bavoil and Sainz
// 2008; CS-C). Each march begins at tan t + tan bias and has even steps up to the radius. No gain makes up for what
// the bias takes off. On a floor seen at a slant, objects still occlude. hbao, which adds angles, finds no occlusion
// there from 72 degrees on.
// Print has its steps at j / 6 of the radius, the same in every pixel. Here each march has a jitter of its own, as the
// study's text advises against regular patterns: (k + jitter) / steps.
struct GloamHbaoStudy {
    float angle_bias;  // radians, added to the tangent plane's elevation by its tangent
    float contrast;    // factor of the result
    uint steps;        // taps along each half of a slice, at least 1
};

// hbao as the comparative study has it (METHOD-hbao_study): `mean of the sum of W(v_k) (sin h_k - sin h_(k-1))` [Aalund
// and Baerentzen 2013, CS-3.2 to 3.4].
// Error: 2.8e-6, 6e-5 where a slice nearly lies in the tangent plane, but for taps within rounding of a pixel's border.
GloamEstimate gloam_hbao_study(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                               GloamHbaoStudy settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    uint steps = max(settings.steps, 1u);
    uint slices = gloam_whole_samples(kernel.count, 2u * steps) / (2u * steps);
    float sum = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        GloamSliceSample random = gloam_slice_sample(kernel.first / (2u * steps) + i + 1u, turns);
        vec2 direction = random.direction * gloam_upright(camera);
        GloamSlice slice = gloam_slice(direction, vec3(0.0, 0.0, 1.0), n);
        GloamSliceAxes axes = gloam_slice_axes(slice, n);
        float slope = gloam_tangent_slope(n, direction);
        vec2 march = vec2(0.0);  // sine of the horizon, occlusion found
        for (int side = 0; side < 2; ++side) {
            float towards = side == 0 ? 1.0 : -1.0;
            march.x = gloam_hbao_start_slope(towards * slope, settings.angle_bias).x;
            for (uint k = 0u; k < steps; ++k) {
                float share = (float(k) + random.jitter) / float(steps);
                ivec2 at = gloam_footprint_pixel(footprint, towards * share * random.direction);
                float depth = gloam_fetch_depth(at);
                march = gloam_hbao_tap(march, footprint, at, depth, position, n, axes, kernel);
            }
        }
        sum += 1.0 - gloam_hbao_visibility(0.5 * march.y, 0.0, settings.contrast);
    }
    return gloam_estimate(sum, float(slices), slices * 2u * steps);
}

// Horizon-split ambient occlusion (Dimitrov, Bavoil and Sainz 2008; CS-C2), the precursor of hbao. The horizons are
// the same, but they come from rays marched in eye space, parallel to the image, in steps of equal length. Each step
// is projected. Two opposite rays are one slice. With the same taps the result is that of hbao, up to intensities
// that bring a single slice above 1.
struct GloamHsao {
    float angle_bias;  // radians above the tangent plane below which nothing blocks
    float contrast;    // factor of the result
    uint steps;        // of a ray, at least 1
};

// hbao by rays in eye space (METHOD-hsao): `mean of the sum of W(v_k) (sin h_k - sin h_(k-1)), over what the bias
// leaves` [Dimitrov, Bavoil and Sainz 2008, CS-C2].
// All samples of one pixel in one frame, by rays.
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
        vec2 march = vec2(gloam_hbao_horizon(n, direction.xy, bias).y, 0.0);
        for (uint k = 0u; k < steps && march.x < 1.0; ++k) {
            vec3 at = gloam_eye_march(position, direction, kernel.radius, k, steps, jitter);
            ivec2 pixel = gloam_footprint_seen(footprint, at);
            float depth = gloam_fetch_depth(pixel);
            if (pixel == footprint.pixel) continue;
            vec3 seen = gloam_footprint_position(footprint, pixel, depth) - position;
            vec3 offset = gloam_into_slice(seen, axis, n);
            vec2 stepped = gloam_hbao_step(march, offset.z, dot(offset, offset), kernel.radius);
            bool counts = gloam_tap_sees(depth) && dot(seen, n) > kernel.bias;
            march = counts ? stepped : march;
        }
        occluded += march.y;
    }
    // The mean over the rays is that of the horizons: what the bias took off it is given back once.
    GloamEstimate estimate = gloam_estimate(occluded, float(rays), rays * steps);
    estimate.occlusion = 1.0 - gloam_hbao_visibility(estimate.occlusion, settings.angle_bias, settings.contrast);
    return estimate;
}

#endif
