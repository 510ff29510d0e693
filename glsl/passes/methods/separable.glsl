// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SEPARABLE_GLSL
#define GLOAM_METHODS_SEPARABLE_GLSL

#include "gloam/filter/weighted_mean.glsl"
#include "gloam/occlusion/separable.glsl"
#include "passes/preparation/directions.glsl"

// Separable ambient occlusion (Huang et al. 2011) of horizon slices, cosine-weighted (gtao): one slice along the first of two directions
// across each other is prepared for every pixel (preparation/first_direction.comp); here is the slice along the second, on whose line the
// first slices of the neighbours are taken over as well, as far as they lie on the same surface. Each frame turns the pair.
// Reads epsilon: standard deviation of that mean, world units.

// Defined by the user: what the preparation passes have written; here the occlusion along the first direction in x.
vec4 gloam_fetch_prepared(ivec2 pixel);

// Of the tangent plane, as a share of the standard deviation, within which a neighbour lies on the same surface.
const float GLOAM_SEPARABLE_HEIGHT = 0.1;

// A neighbour's first slice, added to the mean of them.
GloamWeightedMean gloam_separable_add(GloamWeightedMean mean, ivec2 at, vec3 position, vec3 normal, GloamCamera camera, float sigma) {
    float depth = gloam_fetch_depth(at);
    if (gloam_is_background(depth)) return mean;
    vec3 offset = gloam_camera_position(at, depth, camera) - position;
    float weight = gloam_separable_weight(offset, normal, sigma, GLOAM_SEPARABLE_HEIGHT * sigma);
    return gloam_weighted_mean_add(mean, gloam_fetch_prepared(at).x, weight);
}

// Occlusion along the first direction, of the pixels on the line of the second, two standard deviations to both sides.
float gloam_separable_carried(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, float sigma) {
    vec2 center = gloam_camera_uv(position, camera);
    ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    vec2 reach = gloam_camera_radius(2.0 * sigma, -position.z, camera) * gloam_pair_direction(kernel, true);
    uint steps = gloam_pair_steps(kernel);
    float own = gloam_fetch_prepared(pixel).x;
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own, 1.0);
    for (uint i = 0u; i < 2u * steps; ++i) {
        float share = float(i / 2u + 1u) / float(steps);
        ivec2 at = gloam_nearest_pixel(center + ((i & 1u) == 0u ? share : -share) * reach, camera.size);
        if (at != pixel) mean = gloam_separable_add(mean, at, position, normal, camera, sigma);
    }
    return gloam_weighted_mean_value(mean, own);
}

// All samples of one pixel in one frame, the prepared ones counted.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, samples of both slices) for gloam_estimator_mean. (0, 0) where there is nothing to gather: background, no normal, no radius.
vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (!gloam_can_gather(position, normal, kernel.radius)) return vec2(0.0);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    float second = gloam_pair_occlusion(position, n, camera, kernel, method, true);
    float first = gloam_separable_carried(position, n, camera, kernel, method.epsilon);
    return float(gloam_separable_samples(kernel.count)) * vec2(gloam_separable_mean(first, second), 1.0);
}

#endif
