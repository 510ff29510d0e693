// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_APPEND_GLSL
#define GLOAM_PASSES_TILES_APPEND_GLSL

#include "list.glsl"

// Lets a pass with one invocation a tile fill lists of tiles. Define GLOAM_LIST_BINDING as the binding of the lists.
// Before the first pass that fills them, their counts are 0 and their `layers` 1.

layout(binding = GLOAM_LIST_BINDING, std430) buffer TileLists {
    TileList tile_lists[TILE_LISTS];
    uint listed_tiles[];  // one list after the other, each with room for all tiles
};

// Appends a tile to a list.
// tiles: of the image, along x and y.
void append(uint list, uvec2 tile, uvec2 tiles) {
    uint position = atomicAdd(tile_lists[list].tiles, 1u);
    uint group = position / tiles_of_group(list);
    atomicMax(tile_lists[list].columns, min(group + 1u, LIST_COLUMNS));
    atomicMax(tile_lists[list].rows, group / LIST_COLUMNS + 1u);
    listed_tiles[list * tiles.x * tiles.y + position] = entry_of(tile);
}

#endif
