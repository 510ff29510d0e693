// SPDX-License-Identifier: MIT
#version 450
// Draws refine, halve, join and filter in their tiles alone: two triangles a tile, without vertices. Those of other
// tiles have no area. Draw 6 times as many vertices as marks, with a viewport of 8 x 8 pixels a tile (halve: 4 x 4),
// which may stand out of what is drawn to.
uniform highp sampler2D mark_image;  // of mark; nearest
uniform highp float marked;          // of the tiles that are drawn: 1 for refine, halve and filter, 0 for join

void main() {
    ivec2 count = textureSize(mark_image, 0);
    int n = gl_VertexID / 6;
    ivec2 tile = ivec2(n % count.x, n / count.x);
    int i = gl_VertexID % 6;
    ivec2 corner = ivec2(i % 3 % 2, i % 3 / 2);
    bool drawn = texelFetch(mark_image, tile, 0).x == marked;
    if (i >= 3) corner = 1 - corner;
    gl_Position = drawn ? vec4(2.0 * vec2(tile + corner) / vec2(count) - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 0.0, 1.0);
}
