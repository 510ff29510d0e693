// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SEPARABLE_GLSL
#define GLOAM_METHODS_SEPARABLE_GLSL

#include "gloam/filter/weights.glsl"
#include "gloam/methods/gtao.glsl"
#include "gloam/occlusion/separable.glsl"

// Separable ambient occlusion (Huang et al. 2011) of horizon slices, cosine-weighted (gtao), in two perpendicular
// directions. A pass prepares a slice along the first direction for every pixel (preparation/first_direction.comp).
// The method computes the slice along the second. It also takes the mean of the first slices of the neighbours on the
// line of the second, if they lie on the same surface. Each frame rotates both directions.
struct GloamSeparable {
    float sigma;  // standard deviation of that mean, world units
};

// Of one frame, the taps of both slices to both sides.
const uint GLOAM_SEPARABLE_UNIT = 4u;

// Taps to each side of a slice: each of the two slices has half of the samples.
uint gloam_separable_steps(GloamKernel kernel) {
    return max(kernel.count / GLOAM_SEPARABLE_UNIT, 1u);
}

// The samples of one slice; the directions turn from frame to frame.
// second: the slice across the first. Half a turn of the kernel is a quarter of one of the slices.
GloamKernel gloam_separable_kernel(GloamKernel kernel, bool second) {
    uint taps = 2u * gloam_separable_steps(kernel);
    GloamKernel one = kernel;
    one.angle = kernel.angle + (second ? GLOAM_PI : 0.0);
    one.first = kernel.first / (2u * taps) * taps;
    one.count = taps;
    return one;
}

// Direction of a slice in the image, unit, as gloam_gtao has it.
vec2 gloam_separable_direction(GloamKernel kernel, bool second) {
    GloamKernel one = gloam_separable_kernel(kernel, second);
    return gloam_slice_sample(one.first / one.count + 1u, gloam_turns(one.angle)).direction;
}

// Occlusion of a slice, cosine-weighted. Parameters are those of gloam_gtao.
float gloam_separable_slice(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, bool second) {
    GloamGtao slice = GloamGtao(gloam_separable_steps(kernel));
    return gloam_gtao(position, normal, camera, gloam_separable_kernel(kernel, second), slice).occlusion;
}

// Largest height over the tangent plane, as a fraction of the standard deviation, at which a neighbour lies on the
// same surface.
const float GLOAM_SEPARABLE_HEIGHT = 0.1;

// A neighbour's first slice, added to the mean of them.
GloamWeightedMean gloam_separable_add(GloamWeightedMean mean, GloamFootprint line, ivec2 at, vec3 position, vec3 normal,
                                      float sigma) {
    float depth = gloam_fetch_depth(at);
    if (!gloam_tap_sees(depth)) return mean;
    vec3 offset = gloam_footprint_position(line, at, depth) - position;
    float weight = gloam_separable_weight(offset, normal, sigma, GLOAM_SEPARABLE_HEIGHT * sigma);
    return gloam_weighted_mean_add(mean, gloam_fetch_prepared(at).x, weight);
}

// Occlusion along the first direction, of the pixels on the line of the second, up to two standard deviations to both
// sides.
float gloam_separable_carried(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, float sigma) {
    GloamFootprint line = gloam_footprint(position, 2.0 * max(sigma, 0.0), camera);
    vec2 direction = gloam_separable_direction(kernel, true);
    uint steps = gloam_separable_steps(kernel);
    float own = gloam_fetch_prepared(line.pixel).x;
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own, 1.0);
    for (uint i = 0u; i < 2u * steps; ++i) {
        float share = float(i / 2u + 1u) / float(steps);
        ivec2 at = gloam_footprint_pixel(line, ((i & 1u) == 0u ? share : -share) * direction);
        if (at != line.pixel) mean = gloam_separable_add(mean, line, at, position, normal, sigma);
    }
    return gloam_weighted_mean_value(mean, own);
}

// slices in two directions (METHOD-separable): `(mean of the first along the second + the second) / 2` [Huang et al.
// 2011, CS-O].
// All samples of one pixel in one frame, the prepared ones counted. gloam_fetch_prepared: occlusion along the first
// direction, in x. Error: that of gloam_gtao, and 3e-6 of the mean.
GloamEstimate gloam_separable(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                              GloamSeparable settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    float second = gloam_separable_slice(position, n, camera, kernel, true);
    float first = gloam_separable_carried(position, n, camera, kernel, settings.sigma);
    return GloamEstimate(gloam_separable_mean(first, second),
                         float(gloam_whole_samples(kernel.count, GLOAM_SEPARABLE_UNIT)), 1.0);
}

#endif
