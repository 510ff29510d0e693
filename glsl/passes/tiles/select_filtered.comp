// SPDX-License-Identifier: MIT
#version 450
// Lists the tiles whose filtered occlusion may change in this frame: those that are shaded, and those whose filter reads one that is. Once along x,
// and once along x and y for the pass along y, which reads the result along x. One invocation a tile.
//
// Dispatch ceil(tiles / 8) groups, after select.comp. Descriptor set 0:
//   0  buffer  the tiles' states of this frame
//   1  buffer  the lists: the second and the third are filled
layout(local_size_x = 8, local_size_y = 8) in;

#include "list.glsl"

layout(binding = 0, std430) readonly buffer States { uint states[]; };
layout(binding = 1, std430) buffer TileLists {
    TileList tile_lists[TILE_LISTS];
    uint listed_tiles[];
};

layout(push_constant) uniform Parameters {
    ivec2 size;   // of the images, pixels
    ivec2 reach;  // of the filter along x and y, pixels
} parameters;

bool any_shaded(ivec2 first, ivec2 last, ivec2 tiles) {
    for (int y = max(first.y, 0); y <= min(last.y, tiles.y - 1); ++y) {
        for (int x = max(first.x, 0); x <= min(last.x, tiles.x - 1); ++x) {
            if ((states[y * tiles.x + x] & STATE_SHADED) != 0u) return true;
        }
    }
    return false;
}

void append(uint list, uint tile, ivec2 tiles) {
    uint position = atomicAdd(tile_lists[list].tiles, 1u);
    atomicMax(tile_lists[list].columns, min(position + 1u, LIST_COLUMNS));
    atomicMax(tile_lists[list].rows, position / LIST_COLUMNS + 1u);
    listed_tiles[list * uint(tiles.x * tiles.y) + position] = tile;
}

void main() {
    ivec2 tiles = ivec2(tiles_of(parameters.size));
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= tiles.x || at.y >= tiles.y) return;
    uint tile = uint(at.y * tiles.x + at.x);
    if ((states[tile] & STATE_BACKGROUND) != 0u) return;  // no filter changes background
    ivec2 side = ivec2(TILE_SIDE);
    ivec2 around = (parameters.reach + side - 1) / side;
    ivec2 along_x = ivec2(around.x, 0);
    if (any_shaded(at - along_x, at + along_x, tiles)) append(FILTERED_X_TILES, tile, tiles);
    if (any_shaded(at - around, at + around, tiles)) append(FILTERED_Y_TILES, tile, tiles);
}
