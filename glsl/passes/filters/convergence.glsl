// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_CONVERGENCE_GLSL
#define GLOAM_FILTERS_CONVERGENCE_GLSL

#include "gloam/filter/gaussian.glsl"
#include "gloam/filter/shrink.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/surface_position.glsl"
#include "gloam/temporal/convergence.glsl"

// Pixels that have not converged take after those nearby in the world that have (TSSAO-10 and -11): gloam_convergence_filter over the row, to the
// bit. Reads sigma_pixels, c_adaptive, weight_max and cap.

const int REACH = HALF_WIDTH;

struct Tap {
    vec3 position;  // view space, world units; zero for background
    bool surface;
    float occlusion;
    float convergence;  // [0, 1]; 0, no weight, for background
};

Tap weightless(Tap tap) {
    return Tap(tap.position, false, tap.occlusion, 0.0);
}

Tap tap_at(ivec2 pixel) {
    Source source = source_at(pixel);
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    vec3 position = gloam_camera_position(pixel, source.depth, camera);
    bool surface = gloam_is_surface_position(position);
    return Tap(position, surface, source.occlusion, surface ? gloam_convergence(source.samples, parameters.weight_max) : 0.0);
}

#include "passes/tiles/row.glsl"

// Width of the Gaussian at a pixel, world units.
float sigma_at(vec3 position) {
    float depth = orthographic ? 1.0 : -position.z;
    return gloam_filter_sigma(depth, 1.0 / abs(parameters.p00_p11.y), float(parameters.size.y), parameters.sigma_pixels);
}

// mean: what was added so far. coverage: part of the tap in the window. most: what a convergence counts at most.
// Returns the mean with the tap, as gloam_filter_tap does.
GloamWeightedMean with_tap(GloamWeightedMean mean, vec3 center, Tap tap, float coverage, float sigma, float most) {
    vec3 offset = tap.position - center;
    float weight = coverage * gloam_gaussian(dot(offset, offset), sigma) * min(tap.convergence, most);
    return gloam_weighted_mean_add(mean, tap.occlusion, weight);
}

float filtered_occlusion(int position) {
    Tap own = row_tap(position);
    float most = own.convergence > 0.0 ? max(parameters.cap, 1.0) * own.convergence : 1.0;
    float reach = float(HALF_WIDTH) * gloam_shrink(own.convergence, parameters.c_adaptive);
    float sigma = sigma_at(own.position);
    // The pixel's own distance is 0, and the Gaussian 1.
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own.occlusion, own.convergence);
    UNROLL for (int i = 1; i <= HALF_WIDTH; ++i) {
        if (!HOLDS_ROW && float(i) >= reach + 1.0) break;  // no tap counts from here on
        float coverage = gloam_window_coverage(i, reach);
        mean = with_tap(mean, own.position, row_tap(position - i), coverage, sigma, most);
        mean = with_tap(mean, own.position, row_tap(position + i), coverage, sigma, most);
    }
    // Chosen afterwards and not by a branch around the taps, most of whose cost is that of the row, read for all its pixels.
    bool filters = reach > 0.0 && own.surface;
    return gloam_weighted_mean_value(filters ? mean : gloam_weighted_mean_empty(), own.occlusion);
}

#endif
