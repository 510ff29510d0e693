// SPDX-License-Identifier: MIT
#version 450
// The frame on drivers that run both sides of every branch, behind prepare.comp: lists the tiles that the sweep makes
// (tile_list.glsl), and finds out whether the view is settled. One invocation a tile of 8 x 8 pixels: dispatch
// ceil(tiles / (8, 1)) groups. Bindings are those of descriptor set 0.
layout(local_size_x = 8) in;

layout(binding = 0) uniform highp sampler2D depth_image;         // of prepare.comp; nearest texel, clamped to the edge
layout(binding = 1) uniform highp sampler2D depth_before_image;  // likewise, of the frame before
#ifndef GLOAM_TILES
#define GLOAM_TILES 2
#define GLOAM_SKIPS
#endif

#include "gloam/sampling/depth_levels.glsl"
#include "passes/frame/parameters.glsl"
#include "passes/frame/tile_list.glsl"

layout(constant_id = 7) const int stride = 1;        // pixels of the view from one texel to the next
layout(constant_id = 8) const bool history = false;  // frames follow one another

struct TileParameters {
    vec2 inverse_size;  // 1 over the size of the view
    ivec2 count;        // of tiles
    uint frame;         // its number in the sequence
    uint stands;        // 1: the camera is that of the frame before
};
FRAME_PARAMETERS(TileParameters)

const uint tiles_of_group = uint(2 * stride * stride);  // of the sweep

// A view that has not changed for so many frames is settled: its means have all the frames that they take.
const uint settling_frames = 64u;

// Depth of the i-th 2 x 2 pixels of a tile.
vec4 depths_of(sampler2D image, ivec2 tile, int i) {
    ivec2 block = 4 * tile + ivec2(i % 4, i / 4);
    return textureGather(image, vec2(2 * block + 1) * parameters.inverse_size);
}

void main() {
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (tile.x >= parameters.count.x) return;
    const int blocks = 16;
    bool sees = false;
    for (int i = 0; i < blocks && !sees; ++i)
        sees = any(lessThan(depths_of(depth_image, tile, i), vec4(GLOAM_FARTHEST_LEVEL_DEPTH)));
    bool changed = !history || parameters.stands == 0u;
    for (int i = 0; i < blocks && !changed; ++i)
        changed = abs(depths_of(depth_image, tile, i)) != abs(depths_of(depth_before_image, tile, i));
    uint last = parameters.frame;
    if (changed) atomicExchange(last_changed, last);
    else last = atomicOr(last_changed, 0u);
    if (parameters.frame - last < settling_frames) works[sweeping].groups.z = works[refining].groups.z = 1u;
    uint own = uint(tile.y * parameters.count.x + tile.x);
    if (sees || tiles[own].blank == 0u) tiles[counted(sweeping, tiles_of_group)].swept = uint(tile.x | tile.y << 16);
    tiles[own].blank = sees ? 0u : 1u;
}
