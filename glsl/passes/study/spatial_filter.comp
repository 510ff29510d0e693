// SPDX-License-Identifier: MIT
#version 450
// Smooths the occlusion in the image along one axis: run it along x, then along y on the result. Only for display: the
// history must not contain the result. A file of the folder filters says how: by convergence (TSSAO-10), by normal and
// depth (CS-BLUR), by distance and depth (ISSAO-7), or as SAO.
#include "passes/study/input_image.glsl"

layout(constant_id = 0) const bool along_y = false;       // the second of the two passes
layout(constant_id = 1) const bool orthographic = false;  // else perspective
layout(constant_id = 2) const int filter_half_width = 2;  // taps on each side: 2 is 5 x 5

layout(binding = 0 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT history_image;  // as ambient_occlusion.comp wrote it
layout(binding = 1, r32f) uniform writeonly highp image2D filtered_image;
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;  // read by the filter geometry alone
layout(binding = 3 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT along_x_image;  // what this pass has written along x

layout(push_constant) uniform Parameters {
    vec2 p00_p11;        // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;          // of the images, pixels
    float sigma_pixels;  // convergence, bilateral: width of the Gaussian in the image, pixels: about a quarter of the
                         // window
    float filter_depth;  // geometry, bilateral, sao: difference of depth that sets a neighbour apart, world units, > 0
    float c_adaptive;    // convergence: that from which a pixel is left as it is: 0.2
    float weight_max;    // convergence: samples at which a pixel has converged
    float filter_cap;    // convergence: neighbours weigh at most so many times the pixel's own; 1e18: as printed
} parameters;

// What the images hold for a pixel.
struct Source {
    float occlusion;  // what is filtered, in [0, 1]
    float samples;    // accumulated
    float depth;      // eye-linear, world units
};

Source source_at(ivec2 pixel) {
    vec4 texel = GLOAM_FETCH(history_image, pixel);
    if (along_y) texel.x = GLOAM_FETCH(along_x_image, pixel).x;
    return Source(texel.x, texel.y, texel.w);
}

// The axis in the image, (1, 0) or (0, 1).
ivec2 filter_axis() {
    // By components: with whole vectors (OpSpecConstantOp Select with one condition) lavapipe of Mesa 22.3 selects
    // wrongly.
    return ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
}

// The filter: any file of this folder. It defines filtered_occlusion(pixel), in [0, 1].
#include "filters/convergence.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(filtered_image, pixel, vec4(filtered_occlusion(pixel)));
}
