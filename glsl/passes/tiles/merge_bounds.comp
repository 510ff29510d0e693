// SPDX-License-Identifier: MIT
#version 450
// Computes one level of the pyramid of bounds from the finer level. One invocation for each block of 4 x 4. The bound
// of a plane stays close to the plane.
//
// Dispatch ceil(blocks / 8) groups. Descriptor set 0:
//   0  buffer  the pyramid (bounds.glsl): `level` is written from the level before
layout(local_size_x = 8, local_size_y = 8) in;

#include "bounds.glsl"

layout(binding = 0, std430) buffer Bounds { vec4 bounds[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;  // of the image, pixels
    int level;   // 1 or 2
} parameters;

// Children of the block: first and last, both included.
Block children_of(ivec2 at) {
    ivec2 first = at * BLOCK_CHILDREN;
    return Block(first, min(first + BLOCK_CHILDREN, blocks_of(parameters.size, parameters.level - 1)) - 1);
}

vec4 bound_of_child(ivec2 child) {
    return bounds[bound_index(child, parameters.level - 1, parameters.size)];
}

// Mean of the children's slopes in x and y; the number of children with geometry in z.
vec3 slopes_of(Block children) {
    vec3 sum = vec3(0.0);
    for (int y = children.first.y; y <= children.last.y; ++y) {
        for (int x = children.first.x; x <= children.last.x; ++x) sum += bound_of_child(ivec2(x, y)).yzw;
    }
    return vec3(sum.xy / max(sum.z, 1.0), sum.z);
}

// Constant c of a bound with these slopes that is nowhere below the child's bound. The difference of affine functions
// is largest at a corner.
float constant_over(ivec2 child, vec2 slopes, ivec2 origin) {
    vec4 bound = bound_of_child(child);
    if (bound.w == 0.0) return -GLOAM_LARGEST;
    Block pixels = block_at(child, parameters.level - 1, parameters.size);
    vec2 extent = vec2(pixels.last - pixels.first);
    vec2 offset = vec2(pixels.first - origin);
    vec2 rise = max((bound.yz - slopes) * extent, vec2(0.0));
    // Error: a few operations of 1 ULP each, of numbers no larger than this.
    float rounded = 1e-6 * (abs(bound.x) + dot(abs(bound.yz), extent) + dot(abs(slopes), offset + extent));
    return bound.x + rise.x + rise.y - dot(slopes, offset) + rounded;
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 blocks = blocks_of(parameters.size, parameters.level);
    if (at.x >= blocks.x || at.y >= blocks.y) return;
    Block children = children_of(at);
    vec3 slopes = slopes_of(children);
    float largest = -GLOAM_LARGEST;
    ivec2 origin = block_at(at, parameters.level, parameters.size).first;
    for (int y = children.first.y; y <= children.last.y; ++y) {
        for (int x = children.first.x; x <= children.last.x; ++x)
            largest = max(largest, constant_over(ivec2(x, y), slopes.xy, origin));
    }
    bounds[bound_index(at, parameters.level, parameters.size)] =
        slopes.z == 0.0 ? vec4(0.0) : vec4(largest, slopes.xy, 1.0);
}
