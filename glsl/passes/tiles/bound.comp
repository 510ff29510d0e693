// SPDX-License-Identifier: MIT
#version 450
// How near to the eye the surfaces of each tile come: an upper bound of the inverse depth, affine in the image, since that of a plane is. One group
// of 8 x 8 invocations a tile. Perspective only.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  r32f    eye-linear depth, world units; background 0 or not finite
//   1  buffer  written: for each tile (c, a, b, 1): at a pixel x, y from the tile's first pixel no surface of the tile has an inverse depth
//              above c + a x + b y, in 1 / world units, rounding included; (0, 0, 0, 0) for a tile without geometry
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, std430) writeonly buffer Bounds { vec4 bounds[]; };

layout(push_constant) uniform Parameters {
    ivec2 size;  // of the image, pixels
} parameters;

#include "gloam/geometry/background.glsl"

shared float inverse[64];  // 0 for background
shared uint largest;       // bits of a positive float: ordered as the float is

// Slope of the inverse depth along a row or a column amid the tile; any slope makes a bound, the right one a close bound.
float slope(uint first, uint last) {
    return inverse[first] > 0.0 && inverse[last] > 0.0 ? (inverse[last] - inverse[first]) / 7.0 : 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = pixel.x < parameters.size.x && pixel.y < parameters.size.y;
    float depth = inside ? imageLoad(depth_image, pixel).x : 0.0;
    uint own = gl_LocalInvocationIndex;
    inverse[own] = gloam_is_background(depth) ? 0.0 : 1.0 / depth;
    if (own == 0u) largest = 0u;
    barrier();
    vec2 slopes = vec2(slope(32u, 39u), slope(4u, 60u));
    float level = inverse[own] - dot(slopes, vec2(gl_LocalInvocationID.xy));
    // A bound below 0 may be raised to the least positive number: an inverse depth is positive.
    if (inverse[own] > 0.0) atomicMax(largest, floatBitsToUint(max(level, 1.175494351e-38)));
    barrier();
    if (own > 0u) return;
    float constant = uintBitsToFloat(largest);
    // 2.5 ULP of the quotient, and of two products, two sums and a difference 0.5 ULP each, of numbers no larger than this.
    constant += 1e-6 * (constant + 7.0 * (abs(slopes.x) + abs(slopes.y)));
    uint tile = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    bounds[tile] = largest == 0u ? vec4(0.0) : vec4(constant, slopes, 1.0);
}
