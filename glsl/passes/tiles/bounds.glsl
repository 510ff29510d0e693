// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_TILES_BOUNDS_GLSL
#define GLOAM_PASSES_TILES_BOUNDS_GLSL

#include "list.glsl"

// A pyramid of bounds of the inverse depth: of tiles, of blocks of 4 x 4 tiles, and of 4 x 4 of those, one level
// after the other in one buffer, each by rows. A bound is (c, a, b, 1): at a pixel x, y from the block's first no
// surface of the block has an inverse depth above c + a x + b y, in 1 / world units, rounding included; (0, 0, 0, 0)
// is that of a block without geometry.

const int BOUND_LEVELS = 3;
const int BLOCK_CHILDREN = 4;  // along each axis

// The pixels of a block, clipped to the image: both included.
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

// Where the level starts in the buffer.
int level_offset(ivec2 size, int level) {
    int offset = 0;
    for (int i = 0; i < level; ++i) offset += blocks_of(size, i).x * blocks_of(size, i).y;
    return offset;
}

// Where a block's bound is in the buffer.
int bound_index(ivec2 at, int level, ivec2 size) {
    return level_offset(size, level) + at.y * blocks_of(size, level).x + at.x;
}

Block block_at(ivec2 at, int level, ivec2 size) {
    int side = block_side(level);
    return Block(at * side, min(at * side + side, size) - 1);
}

#endif
