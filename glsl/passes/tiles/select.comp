// SPDX-License-Identifier: MIT
#version 450
// Determines which tiles are shaded in this frame, and lists them. One invocation a tile. A tile is skipped
// - if it has no geometry and all images already show background there: no pass reads or writes it then;
// - if the view stands still and none of its pixels has asked for a sample: both history images then hold the same
//   values and will keep them.
//
// Dispatch ceil(tiles / 8) groups. Descriptor set 0:
//   0  r32f    eye-linear depth, world units; background 0 or not finite
//   1  buffer  the tiles' states after the last frame
//   2  buffer  written: the states after this frame; the counts of shaded tiles become 0
//   3  buffer  the lists, with counts of 0 and `layers` of 1; all lists are filled except those of the filter
#include "passes/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#define GLOAM_LIST_BINDING 3
#include "append.glsl"
#include "state.glsl"

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1, std430) readonly buffer StatesBefore { TileState states_before[]; };
layout(binding = 2, std430) writeonly buffer StatesAfter { TileState states_after[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;        // of the images, pixels
    ivec2 band;        // guard band on each side that is not shaded, pixels
    uint written;      // images that this frame writes: bit i is image i
    uint background;   // 1: skip tiles without geometry
    uint settled;      // 1: skip settled tiles: the view has not changed since the last frame, and stood still then
} parameters;

#include "gloam/geometry/background.glsl"

bool without_geometry(uvec2 tile) {
    ivec2 first = ivec2(tile * TILE_SIDE);
    ivec2 end = min(first + int(TILE_SIDE), parameters.size);
    for (int y = first.y; y < end.y; ++y) {
        // A whole row without a branch: beyond the image its last pixel again.
        bool empty = true;
        for (int i = 0; i < int(TILE_SIDE); ++i) {
            ivec2 pixel = ivec2(min(first.x + i, end.x - 1), y);
            empty = gloam_is_background(GLOAM_FETCH(depth_image, pixel).x) ? empty : false;
        }
        if (!empty) return false;
    }
    return true;
}

const uint PLACES =
    IN_LIST << SHADED_TILES | COUNT_SKIPPED << SKIPPED_BACKGROUND | COUNT_SKIPPED << SKIPPED_SETTLED;

// Where the tile goes (append.glsl): a sum of PLACES. Writes its state.
uint places_of(uvec2 at, uint tile) {
    TileState before = states_before[tile];
    uint written = parameters.written << STATE_BLANK_SHIFT;
    uint blank_images = before.flags >> STATE_BLANK_SHIFT << STATE_BLANK_SHIFT;
    bool settled =
        parameters.settled != 0u && without_samples(before, pixels_of_tile(at, parameters.size, parameters.band));
    // A settled tile stays blank if it was blank before.
    bool blank = parameters.background != 0u && (settled ? blank_images != 0u : without_geometry(at));
    uint kept = blank ? blank_images : 0u;
    if (blank && (blank_images & written) == written) {
        states_after[tile] = TileState(kept | STATE_BACKGROUND, 0u, before.pixels);
        return COUNT_SKIPPED << SKIPPED_BACKGROUND;
    }
    if (settled) {
        states_after[tile] = TileState(kept, 0u, before.pixels);
        return COUNT_SKIPPED << SKIPPED_SETTLED;
    }
    states_after[tile] = TileState(STATE_SHADED | (blank ? kept | written : 0u), 0u, 0u);
    return IN_LIST << SHADED_TILES;
}

void main() {
    uvec2 tiles = tiles_of(parameters.size);
    uvec2 at = gl_GlobalInvocationID.xy;
    bool inside = at.x < tiles.x && at.y < tiles.y;
    append_group(inside ? places_of(at, at.y * tiles.x + at.x) : 0u, PLACES, at, tiles);
}
