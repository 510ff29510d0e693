// SPDX-License-Identifier: MIT
#version 450
// Finds the tiles of which it is certain that no sample of any pixel is blocked: nothing in reach rises above the pixels' tangent planes by as
// much as the bias. One group of 8 x 8 invocations a tile. Perspective only.
//
// The inverse depth of a tangent plane is affine in the image: t(q) = n . ray(q) / n . p. So is the bound of each tile in reach (bound.comp), and
// an affine function that is nowhere above another at the corners of a rectangle is nowhere above it inside. With T(q), the plane of one pixel
// lowered by the most that any other of the tile lies below it within reach, every surface that satisfies
//     bound(q) <= T(q) + beta T_min^2,   beta = bias / (2 r)
// has a depth d >= 1 / (T + beta T^2) >= 1/T - beta: it is in front of no tangent plane by more than beta, and over none by more than beta r (r, the
// longest ray to a point at depth 1). Half of the bias is left for the rounding of the samples themselves, with e = 2^-24:
// - a point's depth comes from two dot products of three terms, exact to 6 e times the sum of their magnitudes, which exceeds the results by
//   k1 = r / (T N) and k2 = (|p| + R) / (N - R), N the distance of the eye from the tangent plane: e (6 k1 + 6 k2 + 8) / T <= bias / 4;
// - a tap's height comes from two positions, exact to 8 e of each: 8 e (2 r / T + |p|) <= bias / 4.
// The planes here are those of the very normals and positions that the samples start from. Of t(q) the three terms, no larger than r / N together,
// are exact to 12 e (a quotient, a product, sums, the normal's length), and N to 6 e |p|, that is t to 6 e |p| t / N; twice that for a plane and the
// one that stands for all.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  rgba32f  view-space normal in xyz
//   2  buffer   the tiles' bounds
//   3  buffer   written: for each tile 1 where that is certain, else 0
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, rgba32f) uniform readonly image2D normal_image;
layout(binding = 2, std430) readonly buffer Bounds { vec4 bounds[]; };
layout(binding = 3, std430) writeonly buffer OpenTiles { uint open_tile[]; };

layout(push_constant) uniform Parameters {
    vec2 p00_p11;  // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;    // of the images, pixels
    float radius;  // of influence, world units
    float bias;    // world units
} parameters;

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "list.glsl"

const float ROUNDING = 6e-8;      // 2^-24
const int MOST_BLOCKS = 4096;     // tiles in reach of one; beyond them nothing is tried
const uint NO_PIXEL = 0xFFFFu;

// A tangent plane: its inverse depth at a place of the image is dot(slopes, ndc) + constant.
struct TangentPlane {
    vec2 slopes;
    float constant;
};

shared uint failed;
shared uint chosen;          // (distance from the tile's centre, invocation) of the pixel whose plane stands for all
shared uint reach_x;         // pixels, bits of floats as the following
shared uint reach_y;
shared uint slack;           // 1 / world units
shared uint farthest;        // |p|, world units
shared uint nearest_plane;   // 1 / N
shared TangentPlane plane_of_all;

// Bits of a number from 0 on: ordered as the numbers are.
uint bits_of(float value) {
    return floatBitsToUint(max(value, 0.0));
}

float inverse_depth(TangentPlane plane, vec2 ndc) {
    return dot(plane.slopes, ndc) + plane.constant;
}

// A corner of a rectangle of pixels, first and last included, in normalised device coordinates.
vec2 corner_of(ivec4 pixels, int corner) {
    ivec2 pixel = ivec2((corner & 1) == 0 ? pixels.x : pixels.z, (corner & 2) == 0 ? pixels.y : pixels.w);
    return gloam_ndc_from_pixel(pixel, parameters.size);
}

// Half-axes, in pixels, of the rectangle around a pixel that holds all samples: a point of the ball is at most R nearer to the eye.
vec2 reach_of(vec3 position) {
    vec2 aside = 1.0 + abs(position.xy) / -position.z;
    vec2 scale = 0.5 * abs(parameters.p00_p11) * vec2(parameters.size);
    return scale * aside * (parameters.radius / (-position.z - parameters.radius)) + 2.0;
}

// The pixels of a tile, clipped to the image: first and last, both included.
ivec4 pixels_of(ivec2 first_tile, ivec2 last_tile) {
    int side = int(TILE_SIDE);
    return ivec4(first_tile * side, min(last_tile * side + side, parameters.size) - 1);
}

bool rises(int block, ivec4 pixels) {
    vec4 bound = bounds[block];
    if (bound.w == 0.0) return false;
    float ray = length(vec3(1.0 / parameters.p00_p11, 1.0));
    float beta = parameters.bias / (2.0 * ray);
    float shortest = uintBitsToFloat(nearest_plane);
    float allowed[4];
    float lowest = 3.402823466e38;
    for (int i = 0; i < 4; ++i) {
        allowed[i] = inverse_depth(plane_of_all, corner_of(pixels, i)) - uintBitsToFloat(slack);
        lowest = min(lowest, allowed[i]);
    }
    if (!(lowest > 1e-18)) return true;
    float aside = uintBitsToFloat(farthest);
    float k1 = ray * shortest / lowest;
    float k2 = (aside + parameters.radius) / (1.0 / shortest - parameters.radius);
    bool exact = ROUNDING * (6.0 * k1 + 6.0 * k2 + 8.0) <= 0.25 * parameters.bias * lowest &&
                 8.0 * ROUNDING * (2.0 * ray / lowest + aside) <= 0.25 * parameters.bias;
    if (!exact) return true;
    for (int i = 0; i < 4; ++i) {
        vec2 from_first = vec2((i & 1) == 0 ? 0 : pixels.z - pixels.x, (i & 2) == 0 ? 0 : pixels.w - pixels.y);
        vec2 sloped = bound.yz * from_first;
        float nearest = bound.x + sloped.x + sloped.y;
        // What these few operations round themselves, of numbers no larger than these.
        float rounded = ROUNDING * (8.0 * (bound.x + abs(sloped.x) + abs(sloped.y)) +
                                    shortest * (24.0 * ray + 12.0 * allowed[i] * aside));
        if (!(nearest + rounded <= allowed[i] + beta * lowest * lowest)) return true;
    }
    return false;
}

void main() {
    uint own = gl_LocalInvocationIndex;
    if (own == 0u) {
        failed = reach_x = reach_y = slack = farthest = nearest_plane = 0u;
        chosen = NO_PIXEL;
    }
    barrier();
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    bool inside = pixel.x < parameters.size.x && pixel.y < parameters.size.y;
    float depth = inside ? imageLoad(depth_image, pixel).x : 0.0;
    bool surface = !gloam_is_background(depth);
    TangentPlane plane = TangentPlane(vec2(0.0), 0.0);
    if (surface) {
        GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, false);
        vec3 position = gloam_camera_position(pixel, depth, camera);
        vec3 normal = gloam_safe_normalize(imageLoad(normal_image, pixel).xyz, vec3(0.0));
        float height = -dot(normal, position);
        bool able = gloam_can_gather(position, normal, parameters.radius) && height > 1.1 * parameters.radius &&
                    depth > 1.1 * parameters.radius;
        plane = TangentPlane(-normal.xy / parameters.p00_p11 / height, normal.z / height);
        if (able) {
            vec2 reach = reach_of(position);
            uvec2 from_middle = uvec2(abs(ivec2(gl_LocalInvocationID.xy) - 4));
            atomicMax(reach_x, bits_of(reach.x));
            atomicMax(reach_y, bits_of(reach.y));
            atomicMax(farthest, bits_of(length(position)));
            atomicMax(nearest_plane, bits_of(1.0 / height));
            atomicMin(chosen, (from_middle.x + from_middle.y) << 8u | own);
        } else {
            atomicOr(failed, 1u);
        }
    }
    barrier();
    if ((chosen & 0xFFu) == own && chosen != NO_PIXEL) plane_of_all = plane;
    ivec2 tiles = ivec2(tiles_of(parameters.size));
    vec2 reach = min(vec2(uintBitsToFloat(reach_x), uintBitsToFloat(reach_y)), vec2(parameters.size));
    ivec2 around = ivec2(ceil(reach / float(TILE_SIDE)));
    ivec2 first = max(ivec2(gl_WorkGroupID.xy) - around, ivec2(0));
    ivec2 last = min(ivec2(gl_WorkGroupID.xy) + around, tiles - 1);
    barrier();
    ivec4 region = pixels_of(first, last);
    for (int i = 0; i < 4 && surface; ++i) {
        vec2 corner = corner_of(region, i);
        atomicMax(slack, bits_of(inverse_depth(plane_of_all, corner) - inverse_depth(plane, corner)));
    }
    barrier();
    ivec2 blocks = last - first + 1;
    int count = blocks.x * blocks.y;
    bool tried = failed == 0u && chosen != NO_PIXEL && count <= MOST_BLOCKS;
    for (int i = int(own); i < count && tried; i += 64) {
        ivec2 block = first + ivec2(i % blocks.x, i / blocks.x);
        if (!rises(block.y * tiles.x + block.x, pixels_of(block, block))) continue;
        atomicOr(failed, 1u);
        break;
    }
    barrier();
    if (own == 0u) open_tile[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = tried && failed == 0u ? 1u : 0u;
}
