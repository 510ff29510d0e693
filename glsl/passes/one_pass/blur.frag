// SPDX-License-Identifier: MIT
#version 450
// Smooths what occlusion.frag has drawn, along one axis. Write the uniforms, the functions engine_... and main() as
// your program has them.

#include "passes/one_pass/depth.glsl"

layout(constant_id = 10) const bool in_column = false;  // else in a row

uniform highp sampler2D occlusion_image;
layout(location = 0) out highp vec4 result;

// Occlusion or visibility.
float engine_occlusion(ivec2 pixel) {
    return texelFetch(occlusion_image, pixel, 0).x;
}

#include "passes/one_pass/blur.glsl"

void main() {
    result = vec4(blurred(ivec2(gl_FragCoord.xy), textureSize(occlusion_image, 0), in_column));
}
