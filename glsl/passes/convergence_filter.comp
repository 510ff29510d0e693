// SPDX-License-Identifier: MIT
#version 450
// Smooths the occlusion of pixels that have not converged yet (TSSAO-10 and -11), along one axis: run it along x, then along y on the
// result. Only for display: the history must not see the result.
//
// Define GLOAM_HISTORY as rgba16f to read a history of half precision, else it is rgba32f.
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  history  occlusion in x, accumulated samples in y, anything in zw: the history, or this pass's result along x
//   2  rgba32f  written: filtered occlusion in x, yzw of binding 1
#ifndef GLOAM_HISTORY
#define GLOAM_HISTORY rgba32f
#endif
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, GLOAM_HISTORY) uniform readonly image2D source_image;
layout(binding = 2, rgba32f) uniform writeonly image2D filtered_image;

layout(push_constant) uniform Parameters {
    vec2 p00_p11;        // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;          // of the images, pixels
    ivec2 axis;          // (1, 0) or (0, 1)
    uint orthographic;   // 1, or 0 for perspective
    int half_width;      // pixels on each side of the window at full width: 2 for 5 x 5
    float c_adaptive;    // convergence from which a pixel is left as it is: 0.2
    float weight_max;    // samples at which a pixel has converged
    float sigma_pixels;  // width of the Gaussian seen head-on, pixels: about a quarter of the window
    float cap;           // neighbours weigh at most this many times the pixel's own convergence; 1e18: as printed. With 1 a
                         // pixel that has just appeared is not overruled by the old ones that happen to be on one side of it
} parameters;

#include "gloam/filter/convergence_filter.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/convergence.glsl"

GloamCamera this_camera() {
    return GloamCamera(parameters.p00_p11, parameters.size, parameters.orthographic != 0u);
}

float most_convergence;

float convergence_of(float weight) {
    return gloam_convergence(weight, parameters.weight_max);
}

vec2 gloam_fetch_occlusion_convergence(ivec2 pixel) {
    vec2 texel = imageLoad(source_image, pixel).xy;
    return vec2(texel.x, min(convergence_of(texel.y), most_convergence));
}

vec3 gloam_fetch_position(ivec2 pixel) {
    return gloam_camera_position(pixel, imageLoad(depth_image, pixel).x, this_camera());
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    vec4 texel = imageLoad(source_image, pixel);
    float own = convergence_of(texel.y);
    most_convergence = own > 0.0 ? max(parameters.cap, 1.0) * own : 1.0;
    float depth = parameters.orthographic != 0u ? 1.0 : imageLoad(depth_image, pixel).x;
    float sigma = gloam_filter_sigma(depth, 1.0 / abs(parameters.p00_p11.y), float(parameters.size.y),
                                     parameters.sigma_pixels);
    texel.x = gloam_convergence_filter(pixel, parameters.axis, parameters.size, parameters.half_width,
                                       parameters.c_adaptive, sigma);
    imageStore(filtered_image, pixel, texel);
}
