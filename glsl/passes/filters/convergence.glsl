// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTERS_CONVERGENCE_GLSL
#define GLOAM_FILTERS_CONVERGENCE_GLSL

#include "gloam/filter/convergence_filter.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/convergence.glsl"

// Pixels that have not converged take after those nearby in the world that have (TSSAO-10 and -11).
// Reads sigma_pixels, c_adaptive, weight_max and cap.

float most_convergence;

float convergence_of(float weight) {
    return gloam_convergence(weight, parameters.weight_max);
}

vec2 gloam_fetch_occlusion_convergence(ivec2 pixel) {
    vec2 texel = source_occlusion_samples(pixel);
    return vec2(texel.x, min(convergence_of(texel.y), most_convergence));
}

vec3 gloam_fetch_position(ivec2 pixel) {
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    return gloam_camera_position(pixel, imageLoad(depth_image, pixel).x, camera);
}

// Occlusion of a pixel of the image, filtered along the axis: in [0, 1].
float filtered_occlusion(ivec2 pixel) {
    float own = convergence_of(imageLoad(history_image, pixel).y);
    most_convergence = own > 0.0 ? max(parameters.cap, 1.0) * own : 1.0;
    float depth = orthographic ? 1.0 : imageLoad(depth_image, pixel).x;
    float sigma = gloam_filter_sigma(depth, 1.0 / abs(parameters.p00_p11.y), float(parameters.size.y), parameters.sigma_pixels);
    return gloam_convergence_filter(pixel, filter_axis(), parameters.size, parameters.half_width, parameters.c_adaptive, sigma);
}

#endif
