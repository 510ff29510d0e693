// SPDX-License-Identifier: MIT
#version 450
// An upper bound of the inverse depth of each tile's surfaces. The bound is affine in the image, as the inverse depth
// of a plane is. One invocation a tile. Perspective only.
//
// Dispatch ceil(tiles / 8) groups. Descriptor set 0:
//   0  r32f    eye-linear depth, world units; background 0 or not finite
//   1  buffer  written: the tiles' bounds, from the start on (bounds.glsl)
#include "passes/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/constants.glsl"
#include "bounds.glsl"

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1, std430) writeonly buffer Bounds { vec4 bounds[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;  // of the image, pixels
} parameters;

// Inverse depth of the surface at a pixel, 1 / world units; 0 for background.
float inverse_at(ivec2 pixel) {
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    return gloam_is_background(depth) ? 0.0 : 1.0 / depth;
}

// Mean slopes between the corners. Any slopes give a valid bound; slopes near the surface's give a close one.
vec2 slopes_of(Block block) {
    float a = inverse_at(block.first);
    float b = inverse_at(ivec2(block.last.x, block.first.y));
    float c = inverse_at(ivec2(block.first.x, block.last.y));
    float d = inverse_at(block.last);
    if (!(min(min(a, b), min(c, d)) > 0.0)) return vec2(0.0);
    return vec2(b + d - a - c, c + d - a - b) / (2.0 * vec2(max(block.last - block.first, ivec2(1))));
}

void main() {
    ivec2 tiles = blocks_of(parameters.size, 0);
    ivec2 tile = ivec2(gl_GlobalInvocationID.xy);
    if (tile.x >= tiles.x || tile.y >= tiles.y) return;
    Block block = block_at(tile, 0, parameters.size);
    vec2 slopes = slopes_of(block);
    float largest = -GLOAM_LARGEST;
    for (int y = block.first.y; y <= block.last.y; ++y) {
        for (int x = block.first.x; x <= block.last.x; ++x) {
            float inverse = inverse_at(ivec2(x, y));
            if (inverse > 0.0) largest = max(largest, inverse - dot(slopes, vec2(ivec2(x, y) - block.first)));
        }
    }
    bool empty = largest == -GLOAM_LARGEST;
    // Error: 2.5 ULP of the quotient, and 1 ULP each of two products, a sum and a difference, of numbers no larger than
    // this. The largest is positive: at the first pixel of a block with slopes nothing is subtracted.
    float rounded = 1e-6 * (largest + dot(abs(slopes), vec2(block.last - block.first)));
    bounds[tile.y * tiles.x + tile.x] = empty ? vec4(0.0) : vec4(largest + rounded, slopes, 1.0);
}
