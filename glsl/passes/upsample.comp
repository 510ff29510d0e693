// SPDX-License-Identifier: MIT
#version 450
// Occlusion at the view's size from that of half-size passes (gloam/filter/upsample.glsl), and its mapping to the
// displayed value (CS-REMAP): visibility v becomes (b (v + a))^c. Only for display: no history may contain the result.
// One invocation for each 2 x 2 pixels. The first of them is the source of the half-size pixel and takes its occlusion.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
// Define GLOAM_SOURCE as r32f if binding 2 is not a history; a history has the format of history_image.glsl.
// Dispatch ceil(ceil(size / 2) / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  r32f     the same at half the size
//   2  source   occlusion in x at half the size: the history, or the filter's result
//   3  output   written: occlusion at the view's size, in [0, 1]; 0 at the background
#include "history_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool remaps = false;        // read a, b and c; else 0, 1, 1
layout(constant_id = 1) const bool orthographic = false;  // the camera; else perspective

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT half_depth_image;
#ifdef GLOAM_SOURCE
layout(binding = 2 GLOAM_FORMAT(GLOAM_SOURCE)) uniform GLOAM_INPUT source_image;
#else
layout(binding = 2 GLOAM_FORMAT(GLOAM_HISTORY)) uniform GLOAM_HISTORY_INPUT source_image;
#endif
#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
layout(binding = 3, GLOAM_OUTPUT) uniform writeonly highp image2D upsampled_image;

layout(push_constant) uniform Parameters {
    ivec2 size;  // of the full-size images, pixels
    float a;     // added to the visibility
    float b;     // brightness
    float c;     // contrast
} parameters;

#include "gloam/filter/half_resolution.glsl"
#include "gloam/filter/upsample.glsl"
#include "gloam/shading/remap.glsl"

float source_at(ivec2 pixel) {
#ifdef GLOAM_SOURCE
    return GLOAM_FETCH(source_image, pixel).x;
#else
    return GLOAM_LOAD_HISTORY_TEXEL(source_image, pixel).x;
#endif
}

// The half-size pixels around a block of 2 x 2 pixels: its own, the next in x, in y and in both.
struct Block {
    vec4 depths;
    vec4 occlusions;
};

Block block_at(ivec2 pixel, ivec2 last) {
    ivec2 next = min(pixel + 1, last);
    ivec2 right = ivec2(next.x, pixel.y);
    ivec2 below = ivec2(pixel.x, next.y);
    return Block(vec4(GLOAM_FETCH(half_depth_image, pixel).x, GLOAM_FETCH(half_depth_image, right).x,
                      GLOAM_FETCH(half_depth_image, below).x, GLOAM_FETCH(half_depth_image, next).x),
                 vec4(source_at(pixel), source_at(right), source_at(below), source_at(next)));
}

// Writes the pixel of the view whose half-size pixels have these depths and occlusions.
void store(ivec2 pixel, vec4 depths, vec4 occlusions) {
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    float occlusion = gloam_upsample(depth, depths, occlusions, orthographic);
    if (remaps && !gloam_is_background(depth))
        occlusion = 1.0 - gloam_remap(1.0 - occlusion, parameters.a, parameters.b, parameters.c);
    imageStore(upsampled_image, pixel, vec4(occlusion));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 last = gloam_half_size(parameters.size) - 1;
    if (pixel.x > last.x || pixel.y > last.y) return;
    Block block = block_at(pixel, last);
    ivec2 first = gloam_half_source(pixel);
    store(first, block.depths.xxxx, block.occlusions.xxxx);
    store(first + ivec2(1, 0), block.depths.xyxy, block.occlusions.xyxy);
    store(first + ivec2(0, 1), block.depths.xxzz, block.occlusions.xxzz);
    store(first + ivec2(1, 1), block.depths, block.occlusions);
}
