// SPDX-License-Identifier: MIT
#version 450
// mark.comp as a fragment shader, of a pixel a tile.
uniform highp usampler2D texel_image;  // nearest, clamped to the edge
layout(location = 0) out highp float marked;

#include "passes/frame/parameters.glsl"

uvec4 four_texels(vec2 at);

#include "passes/frame/mark.glsl"

uvec4 four_texels(vec2 at) {
    vec4 places = at.xyxy + vec4(-0.5, -0.5, 0.5, 0.5) * parameters.inverse_texels.xyxy;
    return uvec4(texture(texel_image, places.xy).x, texture(texel_image, places.zy).x,
                 texture(texel_image, places.xw).x, texture(texel_image, places.zw).x);
}

void main() {
    marked = float(is_marked(ivec2(gl_FragCoord.xy)));
}
