// SPDX-License-Identifier: MIT
#version 450
// Lists the tiles whose filtered occlusion has to be computed in this frame. Along y these are the tiles that the
// filter may change and whose window contains a shaded tile. Along x they are the tiles whose result along x these
// read. A tile that the filter does not change has been written with the samples. One invocation a tile.
//
// Dispatch ceil(tiles / 8) groups, after ambient_occlusion.comp. Descriptor set 0:
//   0  buffer  the tiles' states of this frame
//   1  buffer  the lists: the second and the third are filled
layout(local_size_x = 8, local_size_y = 8) in;

#define GLOAM_LIST_BINDING 1
#include "append.glsl"
#include "state.glsl"

layout(binding = 0, std430) readonly buffer States { TileState states[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;   // of the images, pixels
    ivec2 reach;  // of the filter along x and y, pixels
} parameters;

// The tiles around a tile, itself included: first and last.
ivec4 tiles_around(ivec2 at, ivec2 around, ivec2 tiles) {
    return ivec4(max(at - around, ivec2(0)), min(at + around, tiles - 1));
}

bool any_shaded(ivec2 at, ivec2 around, ivec2 tiles) {
    ivec4 region = tiles_around(at, around, tiles);
    for (int y = region.y; y <= region.w; ++y) {
        for (int x = region.x; x <= region.z; ++x) {
            if ((states[y * tiles.x + x].flags & STATE_SHADED) != 0u) return true;
        }
    }
    return false;
}

// Whether the filter may change any tile around this one.
bool any_filtered(ivec2 at, ivec2 around, ivec2 tiles) {
    ivec4 region = tiles_around(at, around, tiles);
    for (int y = region.y; y <= region.w; ++y) {
        for (int x = region.x; x <= region.z; ++x) {
            TileState state = states[y * tiles.x + x];
            if ((state.flags & STATE_BACKGROUND) == 0u && !unfiltered(state)) return true;
        }
    }
    return false;
}

const uint PLACES =
    IN_LIST << FILTERED_X_TILES | IN_LIST << FILTERED_Y_TILES | COUNT_SKIPPED << SKIPPED_UNFILTERED;

// Where the tile goes (append.glsl): a sum of PLACES.
uint places_of(ivec2 at, ivec2 tiles) {
    TileState state = states[at.y * tiles.x + at.x];
    if ((state.flags & STATE_BACKGROUND) != 0u) return 0u;  // no filter changes background
    if (tile_lists[SHADED_TILES].tiles == 0u) return 0u;    // no tile has changed
    ivec2 side = ivec2(TILE_SIDE);
    ivec2 around = (parameters.reach + side - 1) / side;
    // Along x: every tile whose result may be read, because what is stored there is of an earlier frame with another
    // list.
    bool along_x =
        any_filtered(at, ivec2(0, around.y), tiles) && any_shaded(at, ivec2(around.x, 2 * around.y), tiles);
    uint places = along_x ? IN_LIST << FILTERED_X_TILES : 0u;
    if (!any_shaded(at, around, tiles)) return places;
    return places | (unfiltered(state) ? COUNT_SKIPPED << SKIPPED_UNFILTERED : IN_LIST << FILTERED_Y_TILES);
}

void main() {
    ivec2 tiles = ivec2(tiles_of(parameters.size));
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    bool inside = at.x < tiles.x && at.y < tiles.y;
    append_group(inside ? places_of(at, tiles) : 0u, PLACES, uvec2(at), uvec2(tiles));
}
