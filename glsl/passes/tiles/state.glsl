// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_STATE_GLSL
#define GLOAM_PASSES_TILES_STATE_GLSL

#include "list.glsl"

// What is known about a tile after a frame.
struct TileState {
    uint flags;    // STATE_*
    uint missed;   // samples that its shaded pixels did not take in that frame, of those that each may take
    uint pixels;   // counts of its pixels by kind, COUNT_*; a skipped tile keeps those of when it was last shaded
};

const uint STATE_SHADED = 1u;       // it was in the list
const uint STATE_BACKGROUND = 2u;   // it was skipped by all lists: no geometry, and the images show that already
const uint STATE_BLANK_SHIFT = 8u;  // from this bit on: images that hold background all over the tile

// One pixel of each kind. A count has eight bits: a tile has 64 pixels.
const uint COUNT_BACKGROUND = 1u;
const uint COUNT_BELOW_LIMIT = 1u << 8u;  // the projected radius is below the limit
const uint COUNT_FROZEN = 1u << 16u;      // of a surface that took no sample
const uint COUNT_FILTERED = 1u << 24u;    // which the filter may change

// Number of pixels of a kind. pixels: TileState.pixels. kind: COUNT_*.
uint tile_count(uint pixels, uint kind) {
    return pixels / kind & 0xFFu;
}

// Number of shaded pixels of a tile. size: of the image, pixels. band: guard band on each side that is not shaded.
uint pixels_of_tile(uvec2 tile, ivec2 size, ivec2 band) {
    ivec2 first = ivec2(tile * TILE_SIDE);
    ivec2 sides = min(first + int(TILE_SIDE), size - band) - max(first, band);
    return uint(max(sides.x, 0) * max(sides.y, 0));
}

// Whether no pixel of the tile asked for a sample.
bool without_samples(TileState state, uint shaded_pixels) {
    uint asked_none = tile_count(state.pixels, COUNT_BACKGROUND) + tile_count(state.pixels, COUNT_BELOW_LIMIT) +
                      tile_count(state.pixels, COUNT_FROZEN);
    return asked_none == shaded_pixels;
}

// Whether the filter changes no pixel of the tile.
bool unfiltered(TileState state) {
    return tile_count(state.pixels, COUNT_FILTERED) == 0u;
}

#endif
