// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_SWEEP_GLSL
#define GLOAM_PASSES_FRAME_SWEEP_GLSL

// The horizon sweep of the frame, for compute and fragment shaders. They declare before it:
//   sampler2D depth_image    of prepare, with its levels; nearest texel and level, clamped to the edge
//   sampler2D normal_image   as the engine stores them, any format; with GLOAM_NORMALS_FROM_DEPTH its depth, in x
// In one pass (passes/one_pass) functions of the program take their place.

#include "passes/engine_inputs.glsl"
#include "passes/frame/parameters.glsl"
#include "gloam/filter/frame_texel.glsl"
#include "gloam/geometry/surface.glsl"
#include "gloam/occlusion/sweep_pair.glsl"
#include "gloam/sampling/depth_levels.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/slice_sample.glsl"

layout(constant_id = 5) const int slices = 1;
layout(constant_id = 6) const int steps = 6;   // taps on each side of a slice
layout(constant_id = 7) const int stride = 1;  // pixels of the view from one that is written to the next
layout(constant_id = 8) const bool history = false;  // frames follow one another

const float bias = 0.001;         // least height over the tangent plane, in radii
const float rise = 1.0 / 1024.0;  // the same for each unit of usual depth: two roundings of a depth to 16 bits

// Lengths are in radii of influence. Signs of y, and of x where the projection mirrors, turn view space to the image.
struct SweepParameters {
    mat3x4 view_from_world;  // a rotation in xyz; in w usual_share()'s two numbers, and what view_direction() has
    vec2 inverse_span;       // 1 / (pixels of the view - 1)
    vec2 first;              // middle of the first pixel, in the image from 0 to 1
    vec2 span;               // from there to the middle of the last pixel
    vec2 ray_span;           // likewise, of the ray at depth 1; orthographic: of the position
    vec2 first_ray;          // of the first pixel
    vec2 reach;              // pixels of a radius at depth 1; orthographic: at any
    vec2 noise;              // of the frame: of the turns of slices, and of the shift of taps
#if defined(GLOAM_NORMALS_FROM_DEPTH) && !defined(GLOAM_ONE_PASS)
    vec2 numerator;  // as prepare has them
    vec2 divisor;
    float far;
#endif
};
FRAME_PARAMETERS(SweepParameters)

// What all slices of a pixel share.
struct Point {
    vec2 at;  // 0 to 1, from the first pixel to the last
    float depth;
    float ray_length;
    vec3 view;
    vec3 normal;
    vec2 reach;  // pixels
    vec2 noise;  // turns of the slices, and shift of the taps, in steps
};

#ifndef GLOAM_ONE_PASS
#ifdef GLOAM_NORMALS_FROM_DEPTH
// The farthest one outside the image.
float surface_depth(ivec2 pixel) {
    if (pixel != clamp(pixel, ivec2(0), textureSize(normal_image, 0) - 1)) return GLOAM_FARTHEST_LEVEL_DEPTH;
    return gloam_level_depth(texelFetch(normal_image, pixel, 0).x, parameters.numerator, parameters.divisor,
                             parameters.far);
}
#endif
#endif

#ifdef GLOAM_NORMALS_FROM_DEPTH
// Of the surface at a pixel, radii; zero for background and outside the image.
vec3 position_at(ivec2 pixel) {
    float depth = surface_depth(pixel);
    if (depth >= GLOAM_FARTHEST_LEVEL_DEPTH) return vec3(0.0);
    vec2 ray = vec2(pixel) * parameters.inverse_span * parameters.ray_span + parameters.first_ray;
    return vec3(orthographic ? ray : depth * ray, -depth);
}

vec3 normal_at(ivec2 pixel) {
    vec3 middle = position_at(pixel);
    vec3 along = gloam_neighbor_direction(middle, position_at(pixel - ivec2(1, 0)), position_at(pixel + ivec2(1, 0)));
    vec3 across = gloam_neighbor_direction(middle, position_at(pixel - ivec2(0, 1)), position_at(pixel + ivec2(0, 1)));
    return gloam_facing_normal(along, across, orthographic ? vec3(0.0, 0.0, 1.0) : -middle);
}
#endif

Point point_at(ivec2 pixel, float depth, vec2 reach) {
    vec2 at = vec2(stride * pixel) * parameters.inverse_span;
    vec2 ray = at * parameters.ray_span + parameters.first_ray;
    float squared = orthographic ? 1.0 : dot(ray, ray) + 1.0;
    float inverse = inversesqrt(squared);
    vec3 view = orthographic ? vec3(0.0, 0.0, 1.0) : vec3(-inverse * ray, inverse);
#ifdef GLOAM_NORMALS_FROM_DEPTH
    vec3 normal = normal_at(stride * pixel);
#elif defined(GLOAM_ONE_PASS)
    vec3 normal = engine_normal(stride * pixel);
#else
    vec3 normal = view_direction(texelFetch(normal_image, stride * pixel, 0).xyz, parameters.view_from_world);
#endif
    normal *= inversesqrt(max(dot(normal, normal), GLOAM_LEAST_SQUARE));
    float turns = gloam_lattice_rotation(pixel) * (0.5 / GLOAM_PI);
    vec2 noise = vec2(turns, 14.0 * turns) + (history ? parameters.noise : vec2(0.0));
    return Point(at, depth, squared * inverse, view, normal, reach, noise);
}

// An axis as q of gloam_tap_pair is affine in a place of the image: q = x at.x + y at.y + z. own: s of that axis.
vec3 rays_along(vec3 axis, Point point, float own) {
    vec2 product = axis.xy * parameters.ray_span;
    return vec3(product, (orthographic ? 0.0 : own) - dot(product, point.at));
}

#ifdef GLOAM_BENT_NORMALS
// Sum of the slices' blocked directions (gloam_bent_slice), each with the slice's weight; after texel_of what the
// normal is bent by, turned round.
vec3 blocked = vec3(0.0);
#endif

// What one slice sees, and what an empty one would, both with the slice's weight, and the least depth that taps
// meet, whose sign tells what moved: (occluded, whole, least). At full size some taps tell enough.
vec3 slice_of(Point point, int slice) {
    float angle = GLOAM_PI / float(slices) * (point.noise.x + float(slice));
    vec2 direction = vec2(cos(angle), sin(angle));
    GloamTangentAxes axes = gloam_tangent_axes(direction, point.view, point.normal);
    vec2 slope = point.ray_length * axes.normal;
    vec3 along = rays_along(axes.along, point, slope.y);
    vec3 height = rays_along(axes.height, point, -slope.x);
    float reach = max(abs(point.reach.x), abs(point.reach.y));
    vec3 places = gloam_slice_places(fract(point.noise.y), float(steps), reach);
    vec2 edge = min(point.at, 1.0 - point.at) / parameters.inverse_span;
    float reach_level = gloam_depth_level(min(reach, max(min(edge.x, edge.y), 1.0)));
    vec2 usual = vec2(parameters.view_from_world[0].w, parameters.view_from_world[1].w);
    float least_height = max(bias, rise * usual_share(point.depth, usual, orthographic) * point.depth);
    GloamSweepPair pair = gloam_sweep_pair();
    float least = 0.0;
    for (int k = 0; k < steps; ++k) {
        float place = places.x + float(k) * (places.y + float(k) * places.z);
        vec2 offset = round(place * (point.reach * direction));
        // Beyond the edge, the pixel at the edge.
        vec4 at = clamp(vec4(offset, -offset) * parameters.inverse_span.xyxy + point.at.xyxy, 0.0, 1.0);
        // By the middle of the step, so that the logarithm is a constant.
        float level = reach_level + log2(gloam_slice_place((float(k) + 0.5) / float(steps), 1e18));
#ifdef GLOAM_ONE_PASS
        vec2 stored = vec2(tap_depth(at.xy, level), tap_depth(at.zw, level));
#else
        vec2 stored = vec2(textureLod(depth_image, at.xy * parameters.span + parameters.first, level).x,
                           textureLod(depth_image, at.zw * parameters.span + parameters.first, level).x);
#endif
        if (history && (stride == 2 || (slice == 0 && k % 2 == 0))) least = min(least, min(stored.x, stored.y));
        vec2 depth = history ? abs(stored) : stored;
        vec4 taps = gloam_tap_pair(along.z + along.x * at.xz + along.y * at.yw,
                                   height.z + height.x * at.xz + height.y * at.yw, slope, point.depth, depth,
                                   orthographic);
        // Features are as thick as they are wide.
        pair = gloam_pair_tap(pair, taps, point.depth - depth, place, axes.normal, least_height, 1.0);
    }
    vec2 occluded = pair.occluded + pair.feature;
#ifdef GLOAM_BENT_NORMALS
    vec2 bent = axes.weight * gloam_bent_slice(occluded, axes.normal);
    blocked += bent.x * axes.along + bent.y * point.view;
#endif
    return vec3(axes.weight * (occluded.x + occluded.y), axes.weight * gloam_tangent_whole(axes.normal), least);
}

// The texel of a pixel (gloam/filter/frame_texel.glsl), and its depth for texel_from().
uvec2 texel_of(ivec2 pixel) {
#ifdef GLOAM_ONE_PASS
    float least = depth_in_radii(stride * pixel, 0);
#else
    float least = texelFetch(depth_image, stride * pixel, 0).x;
#endif
    float depth = abs(least);
    vec2 reach = orthographic ? parameters.reach : parameters.reach / depth;
    vec2 sum = vec2(0.0);
    // A radius below a pixel sees nothing but that pixel.
    if (depth < GLOAM_FARTHEST_LEVEL_DEPTH && max(abs(reach.x), abs(reach.y)) >= 1.0) {
        Point point = point_at(pixel, depth, reach);
        for (int i = 0; i < slices; ++i) {
            vec3 slice = slice_of(point, i);
            sum += slice.xy;
            least = min(least, slice.z);
        }
    }
    if (!(sum.x >= 0.0 && sum.y > 0.0)) sum = vec2(0.0, 1e-3);  // background, or no normal
#ifdef GLOAM_BENT_NORMALS
    blocked = dot(blocked, blocked) < 16.0 * sum.y * sum.y ? blocked * (0.5 / sum.y) : vec3(0.0);
#endif
    uint code = gloam_frame_code(depth, min(sum.x / sum.y, 1.0), min(sum.y * (1.0 / float(slices)), 1.6));
    return uvec2(history && least < 0.0 ? code + GLOAM_FRAME_MOVED : code, floatBitsToUint(depth));
}

#ifdef GLOAM_BENT_NORMALS
// Of that pixel, after texel_of(): by what its normal is bent, in the view space of the engine.
vec4 bend_texel() {
    blocked.z -= parameters.view_from_world[2].w * blocked.z;
    return vec4((128.0 - 127.0 * blocked) / 255.0, 1.0);
}
#endif

#endif
