// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_APPEND_GLSL
#define GLOAM_PASSES_TILES_APPEND_GLSL

#include "gloam/numeric/bit_count.glsl"
#include "list.glsl"

// Lets a pass with one invocation a tile fill lists of tiles. Define GLOAM_LIST_BINDING as the binding of the lists.
// Before the first pass that fills them, their counts are 0 and their `layers` 1.

layout(binding = GLOAM_LIST_BINDING, std430) buffer TileLists {
    TileList tile_lists[TILE_LISTS];
    uint listed_tiles[];  // one list after the other, each with room for all tiles
};

// Where a tile goes: a sum of IN_LIST << list and of COUNT_SKIPPED << which.
const uint IN_LIST = 1u;
const uint COUNT_SKIPPED = IN_LIST << SKIPPED_TILES;
const uint SKIPPED_BACKGROUND = 0u;  // counted in `columns` of SKIPPED_TILES
const uint SKIPPED_SETTLED = 1u;     // in its `rows`
const uint SKIPPED_UNFILTERED = 2u;  // in its `tiles`
const uint COUNTERS = SKIPPED_TILES + 3u;

// Of the group: which invocations' tiles go into each list, and are counted, a bit each: from 2 i on for number i.
shared uint group_members[2u * COUNTERS];
shared uint group_first[COUNTERS];  // position of the first of them in the list

// How many invocations before one add to a number; all of them for 64.
uint members_before(uint which, uint invocation) {
    uint low = group_members[2u * which];
    if (invocation < 32u) return gloam_bit_count(low & ((1u << invocation) - 1u));
    uint high = group_members[2u * which + 1u];
    if (invocation < 64u) high &= (1u << (invocation - 32u)) - 1u;
    return gloam_bit_count(low) + gloam_bit_count(high);
}

// Adds the group's tiles to a list or a count.
void add_group(uint which) {
    uint tiles = members_before(which, 64u);
    if (tiles == 0u) return;
    if (which == SKIPPED_TILES + SKIPPED_BACKGROUND) {
        atomicAdd(tile_lists[SKIPPED_TILES].columns, tiles);
    } else if (which == SKIPPED_TILES + SKIPPED_SETTLED) {
        atomicAdd(tile_lists[SKIPPED_TILES].rows, tiles);
    } else if (which == SKIPPED_TILES + SKIPPED_UNFILTERED) {
        atomicAdd(tile_lists[SKIPPED_TILES].tiles, tiles);
    } else {
        uint first = atomicAdd(tile_lists[which].tiles, tiles);
        uint groups = (first + tiles - 1u) / tiles_of_group(which) + 1u;
        atomicMax(tile_lists[which].columns, min(groups, LIST_COLUMNS));
        atomicMax(tile_lists[which].rows, (groups - 1u) / LIST_COLUMNS + 1u);
        group_first[which] = first;
    }
}

// Adds the tiles of a group of 64 to lists and counts, in the order of the invocations. All of them must call it: the
// group asks for its places at once, because a GPU takes additions to one number one after the other.
// places: where the tile of the invocation goes, 0 for none. possible: all places that the pass fills, a constant, so
// that compilers leave out the work for the others. tiles: of the image, along x and y.
void append_group(uint places, uint possible, uvec2 tile, uvec2 tiles) {
    uint invocation = gl_LocalInvocationIndex;
    if (invocation < 2u * COUNTERS) group_members[invocation] = 0u;
    barrier();
    for (uint i = 0u; i < COUNTERS; ++i) {
        if ((possible >> i & 1u) == 0u || (places >> i & 1u) == 0u) continue;
        atomicOr(group_members[2u * i + invocation / 32u], 1u << invocation % 32u);
    }
    barrier();
    if (invocation < COUNTERS) add_group(invocation);
    barrier();
    for (uint list = 0u; list < SKIPPED_TILES; ++list) {
        if ((possible >> list & 1u) == 0u || (places >> list & 1u) == 0u) continue;
        uint position = group_first[list] + members_before(list, invocation);
        listed_tiles[list * tiles.x * tiles.y + position] = entry_of(tile);
    }
}

#endif
