// SPDX-License-Identifier: MIT
#version 450
// filter.comp as a fragment shader.
uniform highp usampler2D texel_image;  // nearest, clamped to the edge
uniform highp sampler2D before_image;
uniform highp sampler2D depth_before_image;
layout(location = 0) out highp float occlusion;

#include "passes/frame/filter.glsl"

GloamFrameTexel texel_at(ivec2 place) {
    return gloam_frame_texel(texture(texel_image, (gl_FragCoord.xy + vec2(place)) * parameters.inverse_size).x);
}

void main() {
    vec4 sums = filtered(ivec2(0));
    occlusion = sums.z / sums.w;
}
