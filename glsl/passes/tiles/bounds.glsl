// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_BOUNDS_GLSL
#define GLOAM_PASSES_TILES_BOUNDS_GLSL

#include "gloam/numeric/constants.glsl"
#include "list.glsl"

// A pyramid of bounds of the inverse depth. Its three levels are tiles, blocks of 4 x 4 tiles, and blocks of 4 x 4 of
// those. They follow one another in one buffer, each by rows.
// A bound is (c, a, b, 1): at the pixel (x, y) from the block's first, no surface of the block has an inverse depth
// above c + a x + b y, in 1 / world units, rounding included. A block without geometry has (0, 0, 0, 0).

const int BOUND_LEVELS = 3;
const int BLOCK_CHILDREN = 4;  // along each axis

// The pixels of a block, clipped to the image; first and last are both included.
struct Block {
    ivec2 first;
    ivec2 last;
};

// Pixels along the side of a block.
int block_side(int level) {
    return int(TILE_SIDE) << (2 * level);
}

// Blocks that cover an image, along x and y.
ivec2 blocks_of(ivec2 size, int level) {
    return (size + block_side(level) - 1) / block_side(level);
}

// Index in the buffer at which the level starts.
int level_offset(ivec2 size, int level) {
    int offset = 0;
    for (int i = 0; i < level; ++i) offset += blocks_of(size, i).x * blocks_of(size, i).y;
    return offset;
}

// Index of a block's bound in the buffer.
int bound_index(ivec2 at, int level, ivec2 size) {
    return level_offset(size, level) + at.y * blocks_of(size, level).x + at.x;
}

Block block_at(ivec2 at, int level, ivec2 size) {
    int side = block_side(level);
    return Block(at * side, min(at * side + side, size) - 1);
}

#endif
