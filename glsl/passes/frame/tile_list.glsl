// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_TILE_LIST_GLSL
#define GLOAM_PASSES_FRAME_TILE_LIST_GLSL

// Tiles of 8 x 8 pixels of the view, listed by where work is. Passes define GLOAM_TILES as the binding of the lists:
// prepare.comp empties them. mark.comp lists which tiles are swept in full and which are joined from half size. With
// GLOAM_SKIPS tiles.comp lists those of the sweep before: drivers on a CPU run both sides of every branch, so only what
// is not dispatched is skipped. That is background that the frame before has written, and all of a settled view.
#ifdef GLOAM_TILES
// Of one list: what a dispatch takes, groups of 16 x 8 invocations, and its tiles.
struct Work {
    uvec3 groups;  // at most groups_across, rows of these, and 1, or 0 for the sweeps of a settled view
    uint count;
};
// The n-th of each list: its column, and from bit 16 on its row.
struct Tile {
    uint refined;  // swept in full, and filtered
    uint joined;
#ifdef GLOAM_SKIPS
    uint swept;
    uint blank;  // of the n-th tile of the view, by rows: 1 where its texels are those of background
#endif
};
// works: of the passes below. last_changed: the last frame in which the view was not that of the frame before.
layout(binding = GLOAM_TILES, std430) buffer Tiles { Work works[4]; uint last_changed; Tile tiles[]; };
const uint sweeping = 0u;
const uint refining = 1u;
const uint filtering = 2u;
const uint joining = 3u;

const uint groups_across = 4096u;  // devices take 65,535 groups in each dimension, and large views have more

void empty_lists() {
#ifdef GLOAM_SKIPS
    const uint awake = 0u;  // tiles.comp finds out
#else
    const uint awake = 1u;
#endif
    for (uint i = 0u; i < 4u; ++i) works[i] = Work(uvec3(0u, 1u, i < filtering ? awake : 1u), 0u);
}

// Counts another tile of a list, whose groups make so many. Returns its number.
uint counted(uint list, uint tiles_of_group) {
    uint n = atomicAdd(works[list].count, 1u);
    uint group = n / tiles_of_group;
    atomicMax(works[list].groups.x, min(group + 1u, groups_across));
    atomicMax(works[list].groups.y, group / groups_across + 1u);
    return n;
}

// Of an invocation that makes `pixels` of the view: the first, counted from that of its tile, and the tile's number in
// the list of the pass.
uvec3 listed(uvec2 pixels) {
    uvec2 at = gl_LocalInvocationID.xy * pixels;
    uint group = gl_WorkGroupID.y * groups_across + gl_WorkGroupID.x;
    return uvec3(at & 7u, 2u * pixels.x * (pixels.y * group + (at.y >> 3u)) + (at.x >> 3u));
}

// First pixel of a tile.
ivec2 tile_at(uint place) {
    return 8 * ivec2(place & 0xFFFFu, place >> 16u);
}
#endif

#endif
