// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_LISTED_GLSL
#define GLOAM_PASSES_TILES_LISTED_GLSL

#include "list.glsl"

// Lets a pass of 8 x 8 pixels a group run over a list of tiles, dispatched by the list itself, or over all of them. Define
// GLOAM_LIST_BINDING as the binding of the lists; they are read when `listed` is set.

layout(constant_id = 10) const bool listed = false;  // run over the list `which_list`; else over the whole image
layout(constant_id = 11) const uint which_list = 0u;

layout(binding = GLOAM_LIST_BINDING, std430) readonly buffer TileLists {
    TileList tile_lists[TILE_LISTS];
    uint listed_tiles[];  // one list after the other, each with room for all tiles
};

// The group's entry of the list: the number of its tile, counted by rows.
// size: of the image, pixels. Returns a number that is no tile of the image for a group beyond the end of the list.
uint group_entry(ivec2 size) {
    if (!listed) return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uvec2 tiles = tiles_of(size);
    uint position = gl_WorkGroupID.y * LIST_COLUMNS + gl_WorkGroupID.x;
    if (position >= tile_lists[which_list].tiles) return tiles.x * tiles.y;
    return listed_tiles[which_list * tiles.x * tiles.y + position];
}

// The invocation's pixel; outside the image for one beyond its edge, and beyond the end of the list.
// entry: of group_entry(). size: of the image, pixels.
ivec2 pixel_of(uint entry, ivec2 size) {
    uint columns = tiles_of(size).x;
    return ivec2(uvec2(entry % columns, entry / columns) * TILE_SIDE + gl_LocalInvocationID.xy);
}

#endif
