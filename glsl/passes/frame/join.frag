// SPDX-License-Identifier: MIT
#version 450
// join.comp as a fragment shader.
uniform highp usampler2D texel_image;  // nearest, clamped to the edge
uniform highp sampler2D before_image;
uniform highp sampler2D depth_before_image;
uniform highp sampler2D depth_image;   // of prepare; likewise
layout(location = 0) out highp float occlusion;
layout(location = 1) out highp vec4 history_texel;  // in sequences

#include "passes/frame/history.glsl"

GloamFrameTexel texel_at(ivec2 place) {
    vec2 block = vec2(ivec2(gl_FragCoord.xy) >> 1) + 0.5;
    return texel_from(texture(texel_image, (block + vec2(place)) * parameters.inverse_texels).xy);
}

#include "passes/frame/join.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = abs(texelFetch(depth_image, pixel, 0).x);
    occlusion = accumulated(pixel, depth, joined(pixel & 1, depth), moved_around());
    history_texel = (floor(kept / frames_unit + 0.5) + 0.25) * frames_unit;  // OpenGL may cut what it stores, not round
}
