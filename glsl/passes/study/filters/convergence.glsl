// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_CONVERGENCE_GLSL
#define GLOAM_FILTERS_CONVERGENCE_GLSL

#include "gloam/filter/convergence_filter.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/blend.glsl"

// Pixels that have not converged take the occlusion of pixels nearby in the world that have (TSSAO-10 and -11). Reads
// sigma_pixels, c_adaptive, weight_max and filter_cap.

float most = 1.0;  // upper limit of the neighbours' convergence

vec2 gloam_fetch_occlusion_convergence(ivec2 pixel) {
    Source source = source_at(pixel);
    return vec2(source.occlusion, min(gloam_convergence(source.samples, parameters.weight_max), most));
}

vec3 gloam_fetch_position(ivec2 pixel) {
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    return gloam_camera_position(pixel, source_at(pixel).depth, camera);
}

float filtered_occlusion(ivec2 pixel) {
    float own = gloam_fetch_occlusion_convergence(pixel).y;
    if (own > 0.0) most = max(parameters.filter_cap, 1.0) * own;
    float depth = orthographic ? 1.0 : source_at(pixel).depth;
    float sigma = gloam_filter_sigma(depth, 1.0 / abs(parameters.p00_p11.y), float(parameters.size.y),
                                     parameters.sigma_pixels);
    return gloam_convergence_filter(pixel, filter_axis(), parameters.size, filter_half_width, parameters.c_adaptive,
                                    sigma);
}

#endif
