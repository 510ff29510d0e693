// SPDX-License-Identifier: MIT
#version 450
// Ambient occlusion in one draw. Write the uniforms, the functions engine_... and main() as your program has them.

uniform highp vec2 p00_p11;
uniform highp float radius;
layout(location = 0) out highp vec4 result;

#include "passes/one_pass/depth.glsl"

#ifndef GLOAM_NORMALS_FROM_DEPTH
uniform highp sampler2D normal_image;

// In view space, of a surface; y as the rows of the depth go where p00_p11 is positive.
vec3 engine_normal(ivec2 pixel) {
    return texelFetch(normal_image, pixel, 0).xyz;
}
#endif

#include "passes/one_pass/occlusion.glsl"

void main() {
    result = vec4(occlusion_at(ivec2(gl_FragCoord.xy), textureSize(depth_image, 0), p00_p11, radius));
}
