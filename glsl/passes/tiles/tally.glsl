// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_TALLY_GLSL
#define GLOAM_PASSES_TILES_TALLY_GLSL

#include "state.glsl"

// Lets a pass count the work of its tiles. Define GLOAM_STATE_BINDING as the binding of the tiles' states. Their counts
// are 0 before the pass. The states are accessed only when `counts` is set.

const uint COUNT_EACH = 1u;   // each invocation adds its own
const uint COUNT_GROUP = 2u;  // the group adds its sum: one write a tile, for memory that is slow to reach

// COUNT_*; 0: nothing is counted. COUNT_EACH is faster where a group's barrier costs more than memory, as on a CPU.
layout(constant_id = 0) const uint counts = 0u;

layout(binding = GLOAM_STATE_BINDING, std430) buffer TileStates { TileState tile_states[]; };

shared uint group_missed;
shared uint group_pixels;

// Adds the invocation's work to its tile. All invocations of the group must call it.
// entry: of the tile (Column.entry). tiles: of the image, along x and y. missed: samples that the invocation's pixels
// did not take (TileState.missed). pixels: sum of COUNT_*. Both are 0 for most invocations, which then write nothing.
void count_tile(uint entry, uvec2 tiles, uint missed, uint pixels) {
    uvec2 at = tile_of(entry);
    uint tile = at.y * tiles.x + at.x;
    bool inside = at.x < tiles.x && at.y < tiles.y;
    if (counts == COUNT_EACH && inside) {
        if (missed > 0u) atomicAdd(tile_states[tile].missed, missed);
        if (pixels > 0u) atomicAdd(tile_states[tile].pixels, pixels);
    }
    if (counts != COUNT_GROUP) return;
    if (gl_LocalInvocationIndex == 0u) group_missed = group_pixels = 0u;
    barrier();
    if (missed > 0u) atomicAdd(group_missed, missed);
    if (pixels > 0u) atomicAdd(group_pixels, pixels);
    barrier();
    if (gl_LocalInvocationIndex != 0u || !inside) return;
    tile_states[tile].missed = group_missed;
    tile_states[tile].pixels = group_pixels;
}

#endif
