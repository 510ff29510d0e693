// SPDX-License-Identifier: MIT
#version 450
// Smooths the occlusion in the image along one axis: run it along x, then along y on the result. Only for display: the history must not
// see the result. How neighbours count is said by a file of the folder filters: by convergence (TSSAO-10), by normal and depth (CS-BLUR), by
// distance and depth (ISSAO-7), or as SAO has it.
//
// Define GLOAM_HISTORY as rgba16f to read a history of half precision, else it is rgba32f.
// Dispatch ceil(size / 8) groups, or a list of tiles (tiles/select_filtered.comp). Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  history  occlusion in x, accumulated samples in y, anything in zw
//   2  r32f     written: filtered occlusion
//   3  rgba32f  view-space normal in xyz; read by the filter geometry alone
//   4  buffer   lists of tiles; read when listed is set
//   5  r32f     what this pass has written along x; read when along_y is set
#ifndef GLOAM_HISTORY
#define GLOAM_HISTORY rgba32f
#endif
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool along_y = false;       // the second of the two passes
layout(constant_id = 1) const bool orthographic = false;  // else perspective

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, GLOAM_HISTORY) uniform readonly image2D history_image;
layout(binding = 2, r32f) uniform writeonly image2D filtered_image;
layout(binding = 3, rgba32f) uniform readonly image2D normal_image;
layout(binding = 5, r32f) uniform readonly image2D along_x_image;

#define GLOAM_LIST_BINDING 4
#include "tiles/listed.glsl"

layout(push_constant) uniform Parameters {
    vec2 p00_p11;        // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;          // of the images, pixels
    int half_width;      // taps on each side: 2 for 5 x 5
    float sigma_pixels;  // convergence, bilateral: width of the Gaussian in the image, pixels: about a quarter of the window
    float depth_scale;   // geometry, bilateral, sao: difference of depth that sets a neighbour apart, world units, > 0
    float c_adaptive;    // convergence: that from which a pixel is left as it is: 0.2
    float weight_max;    // convergence: samples at which a pixel has converged
    float cap;           // convergence: neighbours weigh at most this many times the pixel's own; 1e18: as printed. With 1 a pixel
                         // that has just appeared is not overruled by the old ones that happen to be on one side of it
} parameters;

// Of the image, (1, 0) or (0, 1).
ivec2 filter_axis() {
    // By components: of whole vectors (OpSpecConstantOp Select with one condition) the choice came out wrong on lavapipe, Mesa 22.3.
    return ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
}

// What is filtered, in [0, 1].
float source_occlusion(ivec2 pixel) {
    return along_y ? imageLoad(along_x_image, pixel).x : imageLoad(history_image, pixel).x;
}

// The same, and the samples accumulated.
vec2 source_occlusion_samples(ivec2 pixel) {
    vec2 texel = imageLoad(history_image, pixel).xy;
    return along_y ? vec2(imageLoad(along_x_image, pixel).x, texel.y) : texel;
}

// The filter: any file of this folder.
#include "filters/convergence.glsl"

void main() {
    ivec2 pixel = pixel_of(group_entry(parameters.size));
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(filtered_image, pixel, vec4(filtered_occlusion(pixel)));
}
