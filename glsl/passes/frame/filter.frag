// SPDX-License-Identifier: MIT
#version 450
// filter.comp as a fragment shader. With GLOAM_MARKS it is drawn where tiles are marked, and elsewhere nothing.
uniform highp usampler2D texel_image;  // nearest, clamped to the edge
uniform highp sampler2D before_image;
uniform highp sampler2D depth_before_image;
#ifdef GLOAM_MARKS
uniform highp sampler2D mark_image;  // of mark; nearest
#endif
layout(location = 0) out highp float occlusion;
layout(location = 1) out highp vec4 history_texel;  // in sequences

#include "passes/frame/history.glsl"

GloamFrameTexel texel_at(ivec2 place) {
    return texel_from(texture(texel_image, (gl_FragCoord.xy + vec2(place)) * parameters.inverse_texels).xy);
}

#include "passes/frame/filter.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef GLOAM_MARKS
    if (texelFetch(mark_image, pixel >> 3, 0).x < 0.5) discard;
#endif
    float moved = moved_around(ivec2(-(pixel.x & 1), 0));
    occlusion = accumulated(pixel, texel_at(ivec2(0)).depth, filtered(ivec2(0)), moved);
    history_texel = (floor(kept / frames_unit + 0.5) + 0.25) * frames_unit;  // OpenGL may cut what it stores, not round
}
