// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_LISTED_GLSL
#define GLOAM_PASSES_TILES_LISTED_GLSL

#include "list.glsl"

// Lets a pass with groups of 8 x 8 pixels run over all tiles, or over a list of tiles that is also its indirect
// dispatch. Define GLOAM_LIST_BINDING as the binding of the lists; they are read when `listed` is set.

layout(constant_id = 10) const bool listed = false;  // run over the list `which_list`; else over the whole image
layout(constant_id = 11) const uint which_list = 0u;

layout(binding = GLOAM_LIST_BINDING, std430) readonly buffer TileLists {
    TileList tile_lists[TILE_LISTS];
    uint listed_tiles[];  // one list after the other, each with room for all tiles
};

// One entry (ENTRY_*) of a group that takes several tiles; ENTRY_NONE beyond the end of the list.
// size: of the image, pixels. nth: which of `count`.
uint group_entry_at(ivec2 size, uint nth, uint count) {
    if (!listed) return entry_of(uvec2(gl_WorkGroupID.x * count + nth, gl_WorkGroupID.y));
    uvec2 tiles = tiles_of(size);
    uint position = (gl_WorkGroupID.y * LIST_COLUMNS + gl_WorkGroupID.x) * count + nth;
    if (position >= tile_lists[which_list].tiles) return ENTRY_NONE;
    return listed_tiles[which_list * tiles.x * tiles.y + position];
}

// The pixels of an invocation: a vertical run of one tile.
struct Column {
    uint entry;   // the tile's (ENTRY_*)
    ivec2 first;  // outside the image for a tile beyond its edge, and beyond the end of the list
    int pixels;
};

// The pixels of an invocation, in a group of 64. Neighbouring invocations have neighbouring pixels.
// size: of the image, pixels.
Column column_of_invocation(ivec2 size) {
    uint pixels = tiles_of_group(which_list);
    uint invocations = TILE_SIDE * TILE_SIDE / pixels;  // of a tile
    uint entry = group_entry_at(size, gl_LocalInvocationIndex / invocations, pixels);
    uint within = gl_LocalInvocationIndex % invocations;
    uvec2 first = tile_of(entry) * TILE_SIDE + uvec2(within % TILE_SIDE, within / TILE_SIDE * pixels);
    return Column(entry, ivec2(first), int(pixels));
}

#endif
