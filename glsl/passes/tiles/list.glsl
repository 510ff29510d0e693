// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_LIST_GLSL
#define GLOAM_PASSES_TILES_LIST_GLSL

// Tiles of 8 x 8 pixels, and lists of the tiles on which a pass has to run. A list is also the argument of its indirect
// dispatch. Its rows have at most 32,768 groups, since Vulkan guarantees only 65,535 along an axis.
struct TileList {
    uint columns;  // groups along x, y and z, as an indirect dispatch reads them
    uint rows;
    uint layers;  // 1
    uint tiles;   // in the list
};

const uint TILE_SIDE = 8u;
const uint LIST_COLUMNS = 32768u;

// The lists, by number, and the counts beside them.
const uint SHADED_TILES = 0u;      // reprojection and samples
const uint FILTERED_X_TILES = 1u;  // the filter along x
const uint FILTERED_Y_TILES = 2u;  // the filter along y, and the mapping
const uint SKIPPED_TILES = 3u;     // (background, settled, 0, filtered enough): no list, but counts
const uint TILE_LISTS = 4u;

// Tiles of one group of the filter, whose invocations take several pixels. It takes them along x when it runs over the
// whole image.
const uint FILTER_TILES = 8u;

// Tiles of one group of a list.
uint tiles_of_group(uint list) {
    return list == FILTERED_X_TILES || list == FILTERED_Y_TILES ? FILTER_TILES : 1u;
}

// Fields of a list's entry: the tile's column, and its row from this bit on. Dividing an index by the number of columns
// would cost each invocation more than the entry does.
const uint ENTRY_ROW_SHIFT = 15u;
const uint ENTRY_COLUMN = 0x7FFFu;
const uint ENTRY_NONE = 0xFFFFFFFFu;  // no tile: outside every image

uint entry_of(uvec2 tile) {
    return tile.x | tile.y << ENTRY_ROW_SHIFT;
}

uvec2 tile_of(uint entry) {
    return uvec2(entry & ENTRY_COLUMN, entry >> ENTRY_ROW_SHIFT);
}

// Tiles that cover an image, along x and y.
uvec2 tiles_of(ivec2 size) {
    return (uvec2(size) + (TILE_SIDE - 1u)) / TILE_SIDE;
}

#endif
