// SPDX-License-Identifier: MIT
#version 450
// filter.comp as a fragment shader.
uniform highp usampler2D texel_image;  // nearest, clamped to the edge
uniform highp sampler2D before_image;
uniform highp sampler2D depth_before_image;
layout(location = 0) out highp float occlusion;
layout(location = 1) out highp vec4 history_texel;  // in sequences

#include "passes/frame/history.glsl"

layout(constant_id = 0) const int half_width = 1;  // 1: 3 x 3 pixels; 2: 5 x 5

GloamFrameTexel texel_at(ivec2 place) {
    return texel_from(texture(texel_image, (gl_FragCoord.xy + vec2(place)) * parameters.inverse_texels).xy);
}

#include "passes/frame/filter.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float moved = moved_around(ivec2(-(pixel.x & 1), 0));
    occlusion = accumulated(pixel, texel_at(ivec2(0)).depth, filtered(ivec2(0)), moved);
    history_texel = (floor(kept / frames_unit + 0.5) + 0.25) * frames_unit;  // OpenGL may cut what it stores, not round
}
