// SPDX-License-Identifier: MIT
#version 450
// Lists the tiles whose filtered occlusion has to be formed in this frame: along y those that the filter may change, where it reads a tile that is
// shaded; and along x those whose result along x these read. Tiles that the filter leaves as they are have been written with the samples.
// One invocation a tile.
//
// Dispatch ceil(tiles / 8) groups, after ambient_occlusion.comp. Descriptor set 0:
//   0  buffer  the tiles' states of this frame
//   1  buffer  the lists: the second and the third are filled
layout(local_size_x = 8, local_size_y = 8) in;

#define GLOAM_LIST_BINDING 1
#include "append.glsl"

layout(binding = 0, std430) readonly buffer States { uint states[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;   // of the images, pixels
    ivec2 reach;  // of the filter along x and y, pixels
} parameters;

// Whether the state of any tile around one, itself included, has the bits `mask` as in `bits`.
bool any_around(ivec2 at, ivec2 around, uint mask, uint bits, ivec2 tiles) {
    ivec2 first = max(at - around, ivec2(0));
    ivec2 last = min(at + around, tiles - 1);
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            if ((states[y * tiles.x + x] & mask) == bits) return true;
        }
    }
    return false;
}

void main() {
    ivec2 tiles = ivec2(tiles_of(parameters.size));
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (at.x >= tiles.x || at.y >= tiles.y) return;
    uint state = states[at.y * tiles.x + at.x];
    if ((state & STATE_BACKGROUND) != 0u) return;  // no filter changes background
    ivec2 side = ivec2(TILE_SIDE);
    ivec2 around = (parameters.reach + side - 1) / side;
    uint filtered = STATE_BACKGROUND | STATE_UNFILTERED;
    // Along x wherever it may be read: what is there was formed in a frame whose list was another.
    if (any_around(at, ivec2(0, around.y), filtered, 0u, tiles) &&
        any_around(at, ivec2(around.x, 2 * around.y), STATE_SHADED, STATE_SHADED, tiles)) {
        append(FILTERED_X_TILES, uvec2(at), uvec2(tiles));
    }
    if (!any_around(at, around, STATE_SHADED, STATE_SHADED, tiles)) return;
    if ((state & STATE_UNFILTERED) == 0u) {
        append(FILTERED_Y_TILES, uvec2(at), uvec2(tiles));
    } else {
        atomicAdd(tile_lists[SKIPPED_TILES].tiles, 1u);
    }
}
