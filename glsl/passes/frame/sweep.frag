// SPDX-License-Identifier: MIT
#version 450
// sweep.comp as a fragment shader.
uniform highp sampler2D depth_image;
uniform highp sampler2D normal_image;
layout(location = 0) out highp uvec2 texel;  // where the view is not deep (parameters.glsl), its image has no y

#include "passes/frame/sweep.glsl"

void main() {
    texel = texel_of(ivec2(gl_FragCoord.xy));
}
