// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_CONVERGENCE_GLSL
#define GLOAM_FILTERS_CONVERGENCE_GLSL

#include "gloam/filter/convergence_weight.glsl"
#include "gloam/filter/gaussian.glsl"
#include "gloam/filter/shrink.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/convergence.glsl"

// Pixels that have not converged take the occlusion of pixels nearby in the world that have (TSSAO-10 and -11):
// gloam_convergence_filter over the row, with bit-identical results. Reads sigma_pixels, c_adaptive, weight_max and
// cap.

const int REACH = HALF_WIDTH;

struct Tap {
    vec3 position;  // view space, world units; zero for background
    bool surface;
    float occlusion;
    float convergence;  // [0, 1]; 0, without weight, for background
};

Tap weightless(Tap tap) {
    return Tap(tap.position, false, tap.occlusion, 0.0);
}

Tap tap_at(ivec2 pixel) {
    Source source = source_at(pixel);
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    vec3 position = gloam_camera_position(pixel, source.depth, camera);
    bool surface = position.z < 0.0;  // zero for background and for depth that is not finite
    return Tap(position, surface, source.occlusion,
               surface ? gloam_convergence(source.samples, parameters.weight_max) : 0.0);
}

#include "passes/tiles/row.glsl"

// Scale of the Gaussian at a pixel, 1 / world units.
float scale_at(vec3 position) {
    float depth = orthographic ? 1.0 : -position.z;
    float tan_half_fovy = 1.0 / abs(parameters.p00_p11.y);
    return gloam_gaussian_scale(
        gloam_filter_sigma(depth, tan_half_fovy, float(parameters.size.y), parameters.sigma_pixels));
}

// mean: the sum so far. offset: from the tap and the filtered pixel, the later one in the row minus the earlier one;
// the compiler can then compute it once for both pixels. coverage: part of the tap inside the window. scale: of the
// Gaussian. most: upper limit of the tap's convergence.
// Returns the mean with the tap.
GloamWeightedMean with_tap(GloamWeightedMean mean, vec3 offset, Tap tap, float coverage, float scale, float most) {
    float weight = gloam_convergence_weight(offset, coverage, scale, min(tap.convergence, most));
    return gloam_weighted_mean_add(mean, tap.occlusion, weight);
}

float filtered_occlusion(int position) {
    Tap own = row_tap(position);
    float most = own.convergence > 0.0 ? max(parameters.cap, 1.0) * own.convergence : 1.0;
    float reach = float(HALF_WIDTH) * gloam_shrink(own.convergence, parameters.c_adaptive);
    float scale = scale_at(own.position);
    // The pixel's own distance is 0, so its Gaussian is 1.
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own.occlusion, own.convergence);
    UNROLL for (int i = 1; i <= HALF_WIDTH; ++i) {
        if (!HOLDS_ROW && float(i) >= reach + 1.0) break;  // no tap counts from here on
        float coverage = gloam_window_coverage(i, reach);
        Tap before = row_tap(position - i);
        Tap after = row_tap(position + i);
        mean = with_tap(mean, own.position - before.position, before, coverage, scale, most);
        mean = with_tap(mean, after.position - own.position, after, coverage, scale, most);
    }
    // Selected at the end, without a branch around the taps: the row costs most, and it is read for all pixels of the
    // invocation.
    bool filters = reach > 0.0 && own.surface;
    if (!filters) mean = gloam_weighted_mean_empty();
    return gloam_weighted_mean_value(mean, own.occlusion);
}

#endif
