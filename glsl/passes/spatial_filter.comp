// SPDX-License-Identifier: MIT
#version 450
// Smooths the occlusion in the image along one axis: run it along x, then along y on the result. Only for display: the history must not
// see the result. How neighbours count is said by a file of the folder filters: by convergence (TSSAO-10), by normal and depth (CS-BLUR), by
// distance and depth (ISSAO-7), or as SAO has it.
//
// Define GLOAM_SOURCE as the format of binding 1, else it is rgba32f, and GLOAM_TARGET as that of binding 2, else it is r32f.
// Dispatch ceil(size / 8) groups, or a list of tiles (tiles/select_filtered.comp). Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  source   occlusion in x, accumulated samples in y: the history (rgba32f or rgba16f), or this pass's result along x
//   2  target   written: filtered occlusion in x, y of binding 1 where the format has one
//   3  rgba32f  view-space normal in xyz; read by the filter geometry alone
//   4  buffer   lists of tiles; read when listed is set
#ifndef GLOAM_SOURCE
#define GLOAM_SOURCE rgba32f
#endif
#ifndef GLOAM_TARGET
#define GLOAM_TARGET r32f
#endif
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, GLOAM_SOURCE) uniform readonly image2D source_image;
layout(binding = 2, GLOAM_TARGET) uniform writeonly image2D filtered_image;
layout(binding = 3, rgba32f) uniform readonly image2D normal_image;

#define GLOAM_LIST_BINDING 4
#include "tiles/listed.glsl"

layout(push_constant) uniform Parameters {
    vec2 p00_p11;        // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;          // of the images, pixels
    ivec2 axis;          // (1, 0) or (0, 1)
    uint orthographic;   // 1, or 0 for perspective
    int half_width;      // taps on each side: 2 for 5 x 5
    float sigma_pixels;  // convergence, bilateral: width of the Gaussian in the image, pixels: about a quarter of the window
    float depth_scale;   // geometry, bilateral, sao: difference of depth that sets a neighbour apart, world units, > 0
    float c_adaptive;    // convergence: that from which a pixel is left as it is: 0.2
    float weight_max;    // convergence: samples at which a pixel has converged
    float cap;           // convergence: neighbours weigh at most this many times the pixel's own; 1e18: as printed. With 1 a pixel
                         // that has just appeared is not overruled by the old ones that happen to be on one side of it
} parameters;

// The filter: any file of this folder.
#include "filters/convergence.glsl"

void main() {
    ivec2 pixel = pixel_of(group_entry(parameters.size));
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    float samples = imageLoad(source_image, pixel).y;
    imageStore(filtered_image, pixel, vec4(filtered_occlusion(pixel), samples, 0.0, 0.0));
}
