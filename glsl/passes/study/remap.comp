// SPDX-License-Identifier: MIT
#version 450
// Maps the occlusion to the displayed value (CS-REMAP): visibility v becomes (b (v + a))^c.
// Only for display: the history must not contain the result. a = 0, b = 1, c = 1 change nothing: the pass then only
// converts to the format of the output.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
// Define GLOAM_SOURCE as r32f if binding 1 is not a history.
#include "passes/study/input_image.glsl"

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
#ifndef GLOAM_SOURCE
#define GLOAM_SOURCE rgba32f
#endif
layout(binding = 1 GLOAM_FORMAT(GLOAM_SOURCE)) uniform GLOAM_INPUT source_image;  // history, or the filter's result
#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
layout(binding = 2, GLOAM_OUTPUT) uniform writeonly highp image2D mapped_image;  // in [0, 1]; background as it is

layout(push_constant) uniform Parameters {
    ivec2 size;     // of the images, pixels
    float remap_a;  // added to the visibility
    float remap_b;  // brightness
    float remap_c;  // contrast
} parameters;

#include "gloam/shading/ambient.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    float occlusion = GLOAM_FETCH(source_image, pixel).x;
    if (!gloam_is_background(GLOAM_FETCH(depth_image, pixel).x)) {
        occlusion = 1.0 - gloam_remap(1.0 - occlusion, parameters.remap_a, parameters.remap_b, parameters.remap_c);
    }
    imageStore(mapped_image, pixel, vec4(occlusion));
}
