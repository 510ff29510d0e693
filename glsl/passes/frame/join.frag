// SPDX-License-Identifier: MIT
#version 450
// join.comp as a fragment shader. With GLOAM_MARKS it is drawn where no tile is swept in full, and there nothing.
uniform highp usampler2D texel_image;  // nearest, clamped to the edge
uniform highp sampler2D before_image;
uniform highp sampler2D depth_before_image;
uniform highp sampler2D depth_image;   // of prepare; likewise
#ifdef GLOAM_MARKS
uniform highp sampler2D mark_image;    // of mark; nearest
layout(location = 2) out highp uvec2 texel;  // of the size of the view, for filter
#endif
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
#ifdef GLOAM_MARKS
    if (texelFetch(mark_image, pixel >> 3, 0).x >= 0.5) discard;
#endif
    float depth = abs(texelFetch(depth_image, pixel, 0).x);
    vec4 sums = joined(pixel & 1, depth);
#ifdef GLOAM_MARKS
    texel = full_texel(depth, sums);
#endif
    occlusion = accumulated(pixel, depth, sums, moved_around());
    history_texel = (floor(kept / frames_unit + 0.5) + 0.25) * frames_unit;  // OpenGL may cut what it stores, not round
}
