// SPDX-License-Identifier: MIT
#version 450
#ifndef GL_ES
#extension GL_EXT_control_flow_attributes : require
#endif
// Smooths the occlusion in the image along one axis: run it along x, then along y on the result. Only for display: the
// history must not contain the result. A file of the folder filters defines the weights: by convergence (TSSAO-10), by
// normal and depth (CS-BLUR), by distance and depth (ISSAO-7), or those of SAO.
//
// An invocation filters PIXELS pixels of a tile, in a row along the axis. Their windows overlap. The invocation
// therefore reads the row and the neighbours of its ends once, and computes what a tap needs once for all windows that
// contain it.
//
// The history has the format of history_image.glsl. Define GLOAM_HALF_WIDTH as the number of taps on each side; the
// default is 2 (5 x 5). Dispatch ceil(width / (8 FILTER_TILES)) x ceil(height / 8) groups, or a list of tiles
// (tiles/select_filtered.comp).
// Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite; read where the history rounds
//   1  history  occlusion in x, accumulated samples in y, depth in w as binding 0 has it unless it is rounded
//   2  r32f     written: filtered occlusion
//   3  rgba32f  view-space normal in xyz; read by the filter geometry alone
//   4  buffer   lists of tiles; read when listed is set
//   5  r32f     what this pass has written along x; read when along_y is set
#include "history_image.glsl"
#ifndef GLOAM_HALF_WIDTH
#define GLOAM_HALF_WIDTH 2
#endif
// A row is held in registers, so the loops over it have to be unrolled. The row of a wide window would not fit: it is
// read again for each pixel.
#if GLOAM_HALF_WIDTH <= 8
#define HOLDS_ROW true
#define LOOP_HINT unroll
#else
#define HOLDS_ROW false
#define LOOP_HINT dont_unroll
#endif
#ifdef GL_ES
#define UNROLL
#else
#define UNROLL [[LOOP_HINT]]
#endif
const int HALF_WIDTH = GLOAM_HALF_WIDTH;
#if GLOAM_HALF_WIDTH <= 2
const int PIXELS = 8;           // of an invocation; divides the side of a tile
#define FILTER_INVOCATIONS 64   // of a group: TILE_ROWS for each of FILTER_TILES tiles
#else
const int PIXELS = 4;
#define FILTER_INVOCATIONS 128
#endif

layout(constant_id = 0) const bool along_y = false;       // the second of the two passes
layout(constant_id = 1) const bool orthographic = false;  // else perspective

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(GLOAM_HISTORY)) uniform GLOAM_HISTORY_INPUT history_image;
layout(binding = 2, r32f) uniform writeonly highp image2D filtered_image;
layout(binding = 3 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
layout(binding = 5 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT along_x_image;

#define GLOAM_LIST_BINDING 4
#include "tiles/listed.glsl"

const int TILE_ROWS = int(TILE_SIDE * TILE_SIDE) / PIXELS;  // rows of a tile, one for each invocation
layout(local_size_x = FILTER_INVOCATIONS) in;

layout(push_constant) uniform Parameters {
    vec2 p00_p11;        // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;          // of the images, pixels
    float sigma_pixels;  // convergence, bilateral: width of the Gaussian in the image, pixels: about a quarter of the
                         // window
    float depth_scale;   // geometry, bilateral, sao: difference of depth that sets a neighbour apart, world units, > 0
    float c_adaptive;    // convergence: that from which a pixel is left as it is: 0.2
    float weight_max;    // convergence: samples at which a pixel has converged
    float cap;  // convergence: neighbours weigh at most this many times the pixel's own; 1e18: as printed. With 1 a
                // pixel that has just appeared is not overruled by the old ones that happen to be on one side of it
} parameters;

// What the images hold for a pixel.
struct Source {
    float occlusion;  // what is filtered, in [0, 1]
    float samples;    // accumulated
    float depth;      // eye-linear, world units
};

Source source_at(ivec2 pixel) {
    vec4 texel = GLOAM_LOAD_HISTORY_TEXEL(history_image, pixel);
    if (along_y) texel.x = GLOAM_FETCH(along_x_image, pixel).x;
    if (GLOAM_HISTORY_ROUNDS) texel.w = GLOAM_FETCH(depth_image, pixel).x;
    return Source(texel.x, texel.y, texel.w);
}

// The axis in the image, (1, 0) or (0, 1).
ivec2 filter_axis() {
    // By components: with whole vectors (OpSpecConstantOp Select with one condition) lavapipe of Mesa 22.3 selects
    // wrongly.
    return ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
}

// The filter: any file of this folder. It defines REACH, the pixels that a window reaches to each side; Tap, the data
// of a pixel for all windows that contain it (tiles/row.glsl); and filtered_occlusion(position), in [0, 1], of the
// pixel at a position of the row.
#include "filters/convergence.glsl"

// The first pixel of the invocation; outside the image beyond its edge and beyond the end of the list.
ivec2 first_pixel() {
    int invocation = int(gl_LocalInvocationID.x);
    int row = invocation % TILE_ROWS;
    int side = int(TILE_SIDE);
    // Neighbouring invocations lie across the axis. For the filter along y that is along the rows of the image, whose
    // pixels are read together.
    ivec2 within =
        along_y ? ivec2(row % side, row / side * PIXELS) : ivec2(row % (side / PIXELS) * PIXELS, row / (side / PIXELS));
    return ivec2(tile_of(group_entry_at(parameters.size, uint(invocation / TILE_ROWS), FILTER_TILES))) * side + within;
}

bool in_image(ivec2 pixel) {
    return pixel.x < parameters.size.x && pixel.y < parameters.size.y;
}

void main() {
    ivec2 first = first_pixel();
    if (!in_image(first)) return;
    read_row(first);
    UNROLL for (int i = 0; i < PIXELS; ++i) {
        ivec2 pixel = first + i * filter_axis();
        float value = filtered_occlusion(REACH + i);
        if (in_image(pixel)) imageStore(filtered_image, pixel, vec4(value));
    }
}
