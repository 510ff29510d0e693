// SPDX-License-Identifier: MIT
#version 450
// Says which tiles have to be shaded in this frame, and lists them: one invocation a tile. A tile is left out
// - without any geometry, once the images show background all over it: nothing reads or writes it then;
// - in a view that stands still, once none of its pixels has asked for a sample: both history images hold the same
// then, and will.
//
// Dispatch ceil(tiles / 8) groups. Descriptor set 0:
//   0  r32f    eye-linear depth, world units; background 0 or not finite
//   1  buffer  the tiles' states after the last frame
//   2  buffer  written: after this one, but for the counts of the tiles that are shaded, which become 0
//   3  buffer  the lists, their counts 0 and their `layers` 1; all but those of filters are filled
//   4  buffer  for each tile 1 where nothing can block any tap of its pixels, else 0; read when open_tiles is set
layout(local_size_x = 8, local_size_y = 8) in;

#define GLOAM_LIST_BINDING 3
#include "append.glsl"
#include "state.glsl"

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, std430) readonly buffer StatesBefore { TileState states_before[]; };
layout(binding = 2, std430) writeonly buffer StatesAfter { TileState states_after[]; };
layout(binding = 4, std430) readonly buffer OpenTiles { uint open_tile[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;        // of the images, pixels
    ivec2 band;        // on each side, that is not shaded, pixels
    uint written;      // images that this frame writes, a bit each from 0 on
    uint background;   // 1: leave out tiles without geometry
    uint settled;      // 1: leave out tiles that have settled: the last frame's view was the same, and stood still
    uint open_tiles;   // 1: list tiles that nothing can block apart
} parameters;

#include "gloam/geometry/background.glsl"

bool without_geometry(uvec2 tile) {
    ivec2 first = ivec2(tile * TILE_SIDE);
    ivec2 end = min(first + int(TILE_SIDE), parameters.size);
    for (int y = first.y; y < end.y; ++y) {
        for (int x = first.x; x < end.x; ++x) {
            if (!gloam_is_background(imageLoad(depth_image, ivec2(x, y)).x)) return false;
        }
    }
    return true;
}

void main() {
    uvec2 tiles = tiles_of(parameters.size);
    uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= tiles.x || at.y >= tiles.y) return;
    uint tile = at.y * tiles.x + at.x;
    TileState before = states_before[tile];
    uint written = parameters.written << STATE_BLANK_SHIFT;
    uint blank_images = before.flags >> STATE_BLANK_SHIFT << STATE_BLANK_SHIFT;
    bool settled =
        parameters.settled != 0u && without_samples(before, pixels_of_tile(at, parameters.size, parameters.band));
    // A settled tile is blank where it was blank before.
    bool blank = parameters.background != 0u && (settled ? blank_images != 0u : without_geometry(at));
    uint kept = blank ? blank_images : 0u;
    if (blank && (blank_images & written) == written) {
        atomicAdd(tile_lists[SKIPPED_TILES].columns, 1u);
        states_after[tile] = TileState(kept | STATE_BACKGROUND, 0u, before.pixels);
    } else if (settled) {
        atomicAdd(tile_lists[SKIPPED_TILES].rows, 1u);
        states_after[tile] = TileState(kept, 0u, before.pixels);
    } else {
        append(SHADED_TILES, at, tiles);
        if (parameters.open_tiles != 0u) append(open_tile[tile] != 0u ? OPEN_TILES : SAMPLED_TILES, at, tiles);
        states_after[tile] = TileState(STATE_SHADED | (blank ? kept | written : 0u), 0u, 0u);
    }
}
