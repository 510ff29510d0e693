// SPDX-License-Identifier: MIT
#version 450
// prepare.comp as a fragment shader: one draw for each level.
uniform highp sampler2D stored_image;
uniform highp sampler2D depth_before_image;
uniform int level;  // that is drawn
layout(location = 0) out highp float depth;

vec4 levels_before(vec2 at);

#include "passes/frame/prepare.glsl"

vec4 levels_before(vec2 at) {
    vec2 first = at - 0.5 * parameters.inverse_size;
    vec2 last = at + 0.5 * parameters.inverse_size;
    return vec4(textureLod(depth_before_image, first, 0.0).x, textureLod(depth_before_image, last, 0.0).x,
                textureLod(depth_before_image, vec2(first.x, last.y), 0.0).x,
                textureLod(depth_before_image, vec2(last.x, first.y), 0.0).x);
}

float depth_at(ivec2 pixel) {
    return depth_of(texelFetch(stored_image, min(pixel, textureSize(stored_image, 0) - 1), 0).x);
}

void main() {
    ivec2 pixel = (ivec2(gl_FragCoord.xy) << level) + (1 << level >> 1);
    ivec2 first = pixel & ~1;  // of its block
    depth = sign_of(first, depth_at(first)) * depth_at(pixel);
}
