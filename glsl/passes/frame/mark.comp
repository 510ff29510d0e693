// SPDX-License-Identifier: MIT
#version 450
// The frame with tiles, behind the sweep of every second pixel: marks the tiles of 8 x 8 pixels that are swept in full,
// and lists them and all others (tile_list.glsl). One invocation a tile: dispatch ceil(tiles / (8, 8)) groups. Bindings
// are those of descriptor set 0.
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform highp usampler2D texel_image;  // of sweep.comp, every second pixel; nearest, clamped
layout(binding = 1, r8) uniform highp image2D mark_image;  // written: 1 for a tile that is swept in full, else 0
#ifndef GLOAM_TILES
#define GLOAM_TILES 2
#endif

uvec4 four_texels(vec2 at) {
    return textureGather(texel_image, at);
}

#include "passes/frame/mark.glsl"
#include "passes/frame/tile_list.glsl"

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(tile, imageSize(mark_image)))) return;
    bool marked = is_marked(tile);
#ifdef GLOAM_SKIPS
    if (works[sweeping].groups.z == 0u) marked = imageLoad(mark_image, tile).x > 0.5;  // settled: there are no sweeps
#endif
    imageStore(mark_image, tile, vec4(marked));
    uint place = uint(tile.x | tile.y << 16);
    if (marked) {
        tiles[counted(refining, 2u)].refined = place;
        counted(filtering, 4u);
    } else {
        tiles[counted(joining, 8u)].joined = place;
    }
}
