// SPDX-License-Identifier: MIT
#version 450
// sweep.comp as a fragment shader.
uniform highp sampler2D depth_image;
uniform highp sampler2D normal_image;
layout(location = 0) out highp uint texel;

#include "passes/frame/sweep.glsl"

void main() {
    texel = texel_of(ivec2(gl_FragCoord.xy));
}
