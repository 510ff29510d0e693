// SPDX-License-Identifier: MIT
#version 450
// Finds the tiles in which certainly no sample of any pixel is blocked: no surface within reach rises above the pixels'
// tangent planes by as much as the bias. One invocation a tile. Perspective only.
//
// A sample of the ball of radius R around p is compared at the centre q of its pixel. The plane through the sample that
// is parallel to the tangent plane has at q a depth of at most 1 / t(q), with the tangent plane's inverse depth t(q) =
// n . ray(q) / n . p. So no sample is blocked where every surface has an inverse depth
//   1/s <= t + m t^2,   since then s >= 1/t - m,   m = bias - what rounding adds to the sample's depth.
// Both t and the bound of a block (bounds.glsl) are affine, and t^2 >= T (2 t - T) with T the least t of the block. An
// affine function is nowhere above 0 in a rectangle if it is not above 0 at the corners. All pixels of a tile share the
// plane of one pixel. It is lowered by the largest distance of another plane below it at that pixel, and by the largest
// difference of the slopes for each pixel from there.
//
// Rounding, with e = 2^-24: each operation is exact to 2 e in any rounding mode. N = -n . p; S_p and S_r are the sums
// of magnitudes of the products in n . p and n . ray. A dot product of three with result N and sum of magnitudes S is
// exact to 3 e (S + N), since no partial sum exceeds (S + N) / 2. Positions are exact to 6 e along x and y, as
// documented.
// So n . sample is exact to e (11 S_p + 3 N + 64 R), which includes that the directions lie above the plane to 2e-6.
// n . ray is exact to e (9 S_r + 3 N t), the quotient and the difference to 7 e.
// Together that is at most e ((11 S_p + 64 R) / N + 11 S_r / (N t) + 14) of the depth 1/t, while that is small.
// Other methods use the height of surfaces above the plane, N (1 - t s). It is at most bias where 1/s <= t + m t / N,
// and N t <= S_r. Its rounding, 11 e (S_p + S_r / t), is less than the one above times max(1, S_r). Hence m = bias /
// max(1, S_r) - the rounding above.
//
// Also, a point is at most d + R away. It is at most half a pixel from q, or beyond the edge of the image at which q
// lies.
// Let rise be the increase of t from q to the point. The plane through the point then has at q a depth of at most
// (d + R) (1 + rise / t). A surface further away than that and its rounding blocks nothing either. This decides near
// the eye, where the image shows the ball in front of distant surfaces.
//
// Dispatch ceil(tiles / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  rgba32f  view-space normal in xyz
//   2  buffer   the pyramid of bounds (bounds.glsl)
//   3  buffer   written: for each tile 1 where that is certain, else 0
#include "passes/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
layout(binding = 2, std430) readonly buffer Bounds { vec4 bounds[]; };
layout(binding = 3, std430) writeonly buffer OpenTiles { uint open_tile[]; };

layout(push_constant) uniform Parameters {
    vec2 p00_p11;  // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;    // of the images, pixels
    float radius;  // R, of influence, world units
    float bias;    // world units
    uint points;   // 1: samples are points of the ball; 0: surfaces under the disc of the radius
} parameters;

#include "gloam/geometry/camera.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "bounds.glsl"
#include "tangent_plane.glsl"

const float NEARER = 1.02;  // the eye must be more than this many radii away from the points and from their planes

// What is known about a tile's pixels.
struct Pixels {
    TangentPlane plane;  // of one of the pixels
    float below;         // how far the planes of others lie below it at its pixel, 1 / world units, rounding included
    vec2 diverging;      // largest difference of their slopes from its own, per pixel, rounding included
    float height;        // least N
    vec3 normal;         // largest magnitudes of n
    vec3 position;       // and of p
    vec4 steepest;       // largest slopes towards the left, the top, the right and the bottom, per pixel, at least 0
};
Pixels pixels;
Block reach;     // pixels that samples are compared at: both included
vec2 steepest_ray;  // largest magnitudes along x and y of the rays through them, at depth 1
vec4 overshoot;  // how far the samples reach beyond the left, the top, the right and the bottom of the image, pixels

// Slope of the ray that touches the ball around a point, on the side of larger slopes. slope, depth: of the point,
// which must be further away than the radius.
float touching(float slope, float depth) {
    float beyond = depth * depth * (1.0 + slope * slope) - parameters.radius * parameters.radius;
    float aside = parameters.radius / sqrt(beyond);
    return (slope + aside) / (1.0 - slope * aside);
}

// The same for the disc of the radius.
float beside(float slope, float depth) {
    return slope + 1.00001 * parameters.radius / depth;
}

vec2 furthest(vec2 slopes, float depth) {
    if (parameters.points == 0u) return vec2(beside(slopes.x, depth), beside(slopes.y, depth));
    return vec2(touching(slopes.x, depth), touching(slopes.y, depth));
}

// Finds the pixels at which the samples of a tile are compared. nearest: no surface of the tile is nearer, world units.
void find_reach(Block tile, float nearest) {
    vec2 scale = abs(parameters.p00_p11);
    vec2 least = gloam_ndc_from_pixel(tile.first, parameters.size) / scale;
    vec2 most = gloam_ndc_from_pixel(tile.last, parameters.size) / scale;
    vec2 image = vec2(parameters.size);
    // Two pixels for rounding; samples beyond the image are compared at its edge.
    vec2 first = (-furthest(-least, nearest) * scale * 0.5 + 0.5) * image - 2.0;
    vec2 last = (furthest(most, nearest) * scale * 0.5 + 0.5) * image + 2.0;
    overshoot = max(vec4(-first, last - image), vec4(0.0));
    reach = Block(ivec2(clamp(first, vec2(0.0), image - 1.0)), ivec2(clamp(last, vec2(0.0), image - 1.0)));
    steepest_ray = 1.00001 * max(abs(gloam_ndc_from_pixel(reach.first, parameters.size)),
                                 abs(gloam_ndc_from_pixel(reach.last, parameters.size))) / scale;
}

// Largest distance of the tile's planes below that of its pixel anywhere in a block, 1 / world units.
float lowered(Block block) {
    ivec2 pixel = pixels.plane.pixel;
    return pixels.below + dot(pixels.diverging, vec2(max(abs(block.first - pixel), abs(block.last - pixel))));
}

// Sum of the magnitudes in n . ray.
float sum_of_ray() {
    return dot(pixels.normal, vec3(steepest_ray, 1.0));
}

// Rounding of a sample's depth, relative to 1/t, where the planes' inverse depth is at least `lowest`.
float rounded_depth(float lowest) {
    float of_point = 11.0 * dot(pixels.normal, pixels.position) + 64.0 * parameters.radius;
    return 1.02 * ROUNDING * ((of_point + 11.0 * sum_of_ray() / lowest) / pixels.height + 14.0);
}

// Inverse depth up to which a surface is further away than any point compared within `seen`; 0 if none is known.
float beyond_points(Block seen, float lowest, float rounded) {
    if (parameters.points == 0u) return 0.0;
    vec4 steepest = pixels.steepest;
    vec2 rise = 0.51 * max(steepest.xy, steepest.zw);
    vec4 at_edge = vec4(equal(ivec4(seen.first, seen.last), ivec4(0, 0, parameters.size - 1)));
    float risen = rise.x + rise.y + dot(at_edge * overshoot, steepest);
    return 0.999999 /
           ((pixels.position.z + 1.001 * parameters.radius) * (1.0 + 1.001 * risen / lowest) + rounded / lowest);
}

// Whether a surface of the block may rise above the tile's planes within reach. at: column and row of the block.
bool rises(ivec2 at, int level) {
    vec4 bound = bounds[bound_index(at, level, parameters.size)];
    if (bound.w == 0.0) return false;
    Block block = block_at(at, level, parameters.size);
    Block seen = Block(max(block.first, reach.first), min(block.last, reach.last));
    vec2 extent = vec2(seen.last - seen.first);
    vec2 offset = vec2(seen.first - block.first);
    vec2 slopes = pixels.plane.slopes;
    float allowed = inverse_depth(pixels.plane, seen.first) - lowered(seen);
    vec2 falls = min(slopes * extent, vec2(0.0));
    float lowest = allowed + falls.x + falls.y;
    if (!(lowest > 1e-18)) return true;
    float rounded = rounded_depth(lowest);
    if (!(rounded <= 0.01)) return true;
    float bound_rounded = 10.0 * ROUNDING * (abs(bound.x) + dot(abs(bound.yz), offset + extent));
    float first = bound.x + dot(bound.yz, offset) + bound_rounded;
    vec2 rise = max(bound.yz * extent, vec2(0.0));
    if (first + rise.x + rise.y <= beyond_points(seen, lowest, rounded)) return false;
    float m = 0.999 * parameters.bias / max(1.0, sum_of_ray()) - rounded / lowest;
    // bound - t - m T (2 t - T) at the first corner, and its largest rise from there.
    float above = first - allowed - m * lowest * (2.0 * allowed - lowest);
    vec2 climbs = max((bound.yz - slopes * (1.0 + 2.0 * m * lowest)) * extent, vec2(0.0));
    return !(m >= 0.0 && above + climbs.x + climbs.y <= 0.0);
}

// The blocks of a level that cover these pixels.
Block covering(Block covered, int level) {
    return Block(covered.first / block_side(level), covered.last / block_side(level));
}

// The children of a block that are within reach.
Block children_within_reach(ivec2 at, int level) {
    Block within = covering(reach, level - 1);
    ivec2 first = at * BLOCK_CHILDREN;
    return Block(max(first, within.first), min(first + BLOCK_CHILDREN - 1, within.last));
}

bool tile_rises(ivec2 block) {
    Block children = children_within_reach(block, 1);
    for (int y = children.first.y; y <= children.last.y; ++y) {
        for (int x = children.first.x; x <= children.last.x; ++x) {
            if (rises(ivec2(x, y), 0)) return true;
        }
    }
    return false;
}

bool small_block_rises(ivec2 block) {
    Block children = children_within_reach(block, 2);
    for (int y = children.first.y; y <= children.last.y; ++y) {
        for (int x = children.first.x; x <= children.last.x; ++x) {
            if (rises(ivec2(x, y), 1) && tile_rises(ivec2(x, y))) return true;
        }
    }
    return false;
}

bool any_rises() {
    Block blocks = covering(reach, BOUND_LEVELS - 1);
    for (int y = blocks.first.y; y <= blocks.last.y; ++y) {
        for (int x = blocks.first.x; x <= blocks.last.x; ++x) {
            if (rises(ivec2(x, y), 2) && small_block_rises(ivec2(x, y))) return true;
        }
    }
    return false;
}

// The tangent plane of a pixel with geometry; its height is 0 where it cannot be used.
TangentPlane plane_at(ivec2 pixel, float depth) {
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, false);
    vec3 normal = GLOAM_FETCH(normal_image, pixel).xyz;
    TangentPlane plane = tangent_plane(pixel, depth, normal, camera);
    bool able = gloam_can_gather(gloam_camera_position(pixel, depth, camera), normal, parameters.radius, camera) &&
                plane.height > NEARER * parameters.radius;
    if (!able) plane.height = 0.0;
    return plane;
}

// Merges another pixel's plane into the bounds of the tile.
void include(TangentPlane plane) {
    ivec2 pixel = pixels.plane.pixel;
    pixels.below =
        max(pixels.below, pixels.plane.inverse - inverse_depth(plane, pixel) + inverse_depth_error(plane, pixel));
    pixels.diverging =
        max(pixels.diverging, abs(pixels.plane.slopes - plane.slopes) + plane.rounded * abs(plane.slopes));
    pixels.height = min(pixels.height, plane.height);
    pixels.normal = max(pixels.normal, plane.normal);
    pixels.position = max(pixels.position, plane.position);
    pixels.steepest = max(pixels.steepest, vec4(-plane.slopes, plane.slopes));
}

// Merges the planes of all pixels of the tile. Returns false if one cannot be used.
bool include_all(Block tile) {
    for (int y = tile.first.y; y <= tile.last.y; ++y) {
        for (int x = tile.first.x; x <= tile.last.x; ++x) {
            float depth = GLOAM_FETCH(depth_image, ivec2(x, y)).x;
            if (gloam_is_background(depth)) continue;
            TangentPlane plane = plane_at(ivec2(x, y), depth);
            if (plane.height <= 0.0) return false;
            include(plane);
        }
    }
    return true;
}

// Early out: tests the plane of one pixel, first against its own tile, before all pixels are read.
bool is_open(ivec2 at) {
    Block tile = block_at(at, 0, parameters.size);
    vec4 bound = bounds[bound_index(at, 0, parameters.size)];
    vec2 climbs = max(bound.yz * vec2(tile.last - tile.first), vec2(0.0));
    float nearest = 0.999 / (bound.x + climbs.x + climbs.y);
    if (bound.w == 0.0 || !(nearest > NEARER * parameters.radius)) return false;
    ivec2 middle = (tile.first + tile.last + 1) / 2;
    float depth = GLOAM_FETCH(depth_image, middle).x;
    if (gloam_is_background(depth)) return false;
    TangentPlane plane = plane_at(middle, depth);
    if (plane.height <= 0.0) return false;
    find_reach(tile, nearest);
    pixels = Pixels(plane, 0.0, vec2(0.0), plane.height, plane.normal, plane.position,
                    max(vec4(-plane.slopes, plane.slopes), vec4(0.0)));
    if (rises(at, 0) || any_rises() || !include_all(tile)) return false;
    // Rounding of the shared plane: once where it is compared with the others, once where it is compared with blocks.
    pixels.below += 2.0 * inverse_depth_error(plane, middle);
    pixels.diverging += (plane.rounded + 20.0 * ROUNDING) * abs(plane.slopes);
    return !any_rises();
}

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    ivec2 tiles = blocks_of(parameters.size, 0);
    if (at.x >= tiles.x || at.y >= tiles.y) return;
    open_tile[at.y * tiles.x + at.x] = is_open(at) ? 1u : 0u;
}
