// SPDX-License-Identifier: MIT
#version 450
// sweep.comp as a fragment shader. With GLOAM_MARKS it is drawn where tiles are marked, and elsewhere nothing.
uniform highp sampler2D depth_image;
uniform highp sampler2D normal_image;
#ifdef GLOAM_MARKS
uniform highp sampler2D mark_image;  // of mark; nearest
#endif
layout(location = 0) out highp uvec2 texel;  // where the view is not deep (parameters.glsl), its image has no y

#include "passes/frame/sweep.glsl"

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
#ifdef GLOAM_MARKS
    if (texelFetch(mark_image, pixel >> 3, 0).x < 0.5) discard;
#endif
    texel = texel_of(pixel);
}
