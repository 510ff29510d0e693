// SPDX-License-Identifier: MIT
#ifndef GLOAM_PREPARATION_PASS_GLSL
#define GLOAM_PREPARATION_PASS_GLSL

// The common part of the preparation passes. They run before ambient_occlusion.comp, in the order of their method's
// list. Each writes a part of one image, which the method reads by gloam_fetch_prepared. The image keeps nothing from
// frame to frame. history_before and layer_image are those of ambient_occlusion.comp, of which the first are pixels of
// this frame.
//
// Define GLOAM_PREPARED as r32f for the passes whose image has one channel (first_direction.comp, depth_chain.comp,
// disc_visibility.comp); the default is rgba32f.
#include "passes/study/input_image.glsl"
#ifndef GLOAM_PREPARED
#define GLOAM_PREPARED rgba32f
#endif

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT history_before;
layout(binding = 3, GLOAM_PREPARED) uniform writeonly highp image2D prepared_image;

#include "gloam/geometry/pixel.glsl"
#include "passes/study/method_values.glsl"

layout(binding = 4, std430) readonly buffer MethodSettings { MethodValues method_values; };
layout(binding = 5 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT layer_image;
layout(binding = 6 GLOAM_FORMAT(GLOAM_PREPARED)) uniform GLOAM_INPUT earlier_image;  // that of binding 3

#include "passes/study/pixel_samples.glsl"

vec3 gloam_fetch_layers(ivec2 pixel) {
    return GLOAM_FETCH(layer_image, pixel).xyz;
}

float gloam_fetch_depth(ivec2 pixel) {
    return GLOAM_FETCH(depth_image, pixel).x;
}

// What earlier passes have written, as the method reads it.
vec4 gloam_fetch_prepared(ivec2 texel) {
    return GLOAM_FETCH(earlier_image, texel);
}

// The samples that ambient_occlusion.comp takes at a pixel in this frame.
GloamKernel kernel_at(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    GloamHistory before = gloam_history_empty(0.0);
    if (keeps_history) before = gloam_history_unpack(GLOAM_FETCH(history_before, pixel));
    return kernel_of(pixel, depth, before, samples_at(before, depth));
}

// Whether no pixel of the frame is within this distance. Such a pixel is read by the guard band only.
bool far_from_frame(ivec2 pixel, int pixels) {
    if (parameters.shade_border != 0u) return false;
    ivec2 inner = pixel - parameters.border;
    ivec2 apart = abs(inner - gloam_clamp_to_edge(inner, parameters.size - 2 * parameters.border));
    return max(apart.x, apart.y) > pixels;
}

#endif
