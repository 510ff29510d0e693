// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_TILE_LIST_GLSL
#define GLOAM_PASSES_FRAME_TILE_LIST_GLSL

// The tiles of 16 x 8 texels that the sweep makes. Drivers on a CPU run both sides of every branch: only what is not
// dispatched is skipped. That is tiles of background that the frame before has written, and all of a settled view,
// whose history stays. Passes define GLOAM_TILES as the list's binding: prepare.comp empties it, tiles.comp fills it.
#ifdef GLOAM_TILES
struct Tile {
    uint place;  // of the n-th tile that the sweep makes: column, and from bit 16 on row
    uint blank;  // of the n-th tile by rows: 1 where its texels are those of background
};
layout(binding = GLOAM_TILES, std430) buffer TileList {
    uvec3 groups;       // of the sweep: tiles; 1, or 0 in a settled view; 1
    uint last_changed;  // the last frame in which the view was not that of the frame before
    Tile tiles[];
};

// First texel of a tile of the list.
ivec2 tile_at(uint n) {
    return ivec2(16, 8) * ivec2(tiles[n].place & 0xFFFFu, tiles[n].place >> 16u);
}
#endif

#endif
