// SPDX-License-Identifier: MIT
#version 450
// What sweep.comp with GLOAM_MARKS writes of its texels for join, as a fragment shader of the texels at half size.
uniform highp usampler2D texel_image;  // of the size of the view
uniform highp sampler2D mark_image;    // of mark; nearest
layout(location = 0) out highp uvec2 texel;

void main() {
    ivec2 place = ivec2(gl_FragCoord.xy);
    if (texelFetch(mark_image, place >> 2, 0).x < 0.5) discard;
    texel = texelFetch(texel_image, 2 * place, 0).xy;
}
