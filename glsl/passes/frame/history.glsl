// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_HISTORY_GLSL
#define GLOAM_PASSES_FRAME_HISTORY_GLSL

// What filter and join share: their parameters, and what the frame keeps of the frames before, behind its filter: a
// texel of 32 bits a pixel, two means and a number of frames (gloam/temporal/frame_history.glsl), and the depth of the
// frame before. Shaders declare before it:
//   sampler2D before_image         the history of the frame before; bilinear, clamped to the edge
//   sampler2D depth_before_image   level 0 of its depth; nearest, clamped to the edge

#include "gloam/filter/frame_texel.glsl"
#include "gloam/shading/ambient.glsl"
#include "gloam/temporal/frame_history.glsl"
#include "passes/frame/parameters.glsl"
#include "passes/frame/tile_list.glsl"

layout(constant_id = 1) const bool orthographic = false;  // both cameras; else perspective
layout(constant_id = 8) const bool history = false;       // there is one
layout(constant_id = 10) const bool visibility = false;   // is what is shown; else occlusion

struct LastParameters {
    mat4x3 before;        // where a pixel's point was (gloam_frame_before)
    float most;           // frames before this one in the mean, in frames_unit; 0 begins a sequence
    float range;          // how far the mean may be from the fast one,
    float narrowing;      // and how much nearer it is where taps met what moved
    float sharpness;      // the part of the neighbours' weights that a long mean leaves out
    float dither;         // of the frame, in [0, 1)
#ifdef GLOAM_MULTI_BOUNCE
    float albedo;         // of what blocks, in [0, 1]
#endif
    vec2 inverse_texels;  // 1 over the size of the texels,
    vec2 inverse_size;    // and of the view
    vec2 usual;           // usual_share()
};
FRAME_PARAMETERS(LastParameters)

const float frames_unit = 1.0 / 1023.0;      // of the number of frames in its channel
const float most_moved = 7.0 * frames_unit;  // frames before this one in the mean where a tap met what moved
const float depth_tolerance = 0.015;         // relative, to be the same surface

// A texel as the sweep stores it.
GloamFrameTexel texel_from(uvec2 stored) {
    GloamFrameTexel texel = gloam_frame_texel(stored.x);
    if (deep) texel.depth = uintBitsToFloat(stored.y);
    return texel;
}

// What a texel adds to sums: its weighted occlusion, and its weight.
vec2 sums_of(GloamFrameTexel texel) {
    return texel.weight * vec2(texel.occlusion, 1.0);
}

#ifdef GLOAM_BENT_NORMALS
vec3 bent;        // added to the pixel's normal, before it is normalised
vec4 bends;       // weighted sum of ((128 + 127 bent) / 255, 1), of the texels that the filter reads
vec2 first_bend;  // middle of the texel at place 0, in the image from 0 to 1

vec3 bend_at(ivec2 place) {
    return textureLod(bend_image, vec2(place) * parameters.inverse_texels + first_bend, 0.0).xyz;
}

#endif
vec4 kept = vec4(0.0);  // the texel of a pixel for the next frame, in sequences

// What is shown of a pixel, with its history, if there is one, in [0, 1]. sums: of the occlusion and the weight of the
// pixel itself, and of all that the filter reads. moved: the share of these that met what moved.
float accumulated(ivec2 pixel, float depth, vec4 sums, float moved) {
    vec2 means = vec2(sums.z / sums.w);  // at first what the filter gives
#ifdef GLOAM_BENT_NORMALS
    bent = (bends.xyz / bends.w - 128.0 / 255.0) * (255.0 / 127.0);
#endif
    if (history) {
        vec3 was = gloam_frame_before(vec2(pixel), depth, parameters.before, orthographic);
        vec3 texel = textureLod(before_image, was.xy, 0.0).xyz;
        float apart = abs(abs(textureLod(depth_before_image, was.xy, 0.0).x) - was.z);
        float tolerance = depth_tolerance * usual_share(was.z, parameters.usual, orthographic);
        bool known = all(lessThan(abs(was.xy - 0.5), vec2(0.5))) && apart < tolerance * was.z;
        float frames = known ? min(texel.z, moved > 0.0 ? min(parameters.most, most_moved) : parameters.most) : 0.0;
        float weight = 1.0 / (frames * (1.0 / frames_unit) + 1.0);
        float part = parameters.sharpness - parameters.sharpness * moved;
        float fresh = gloam_frame_sharp(sums.xy, sums.zw, part - part * weight);
        means = gloam_frame_blend(texel.x, texel.y, weight, fresh, means.x,
                                  parameters.range - parameters.narrowing * moved);
        float dither = fract(float(pixel.x) * 0.7548777 + (float(pixel.y) * 0.5698403 + parameters.dither)) - 0.5;
        kept = vec4(means.x + dither * frames_unit, means.y, frames + frames_unit, 0.0);
#ifdef GLOAM_BENT_NORMALS
        vec3 bent_before = 2.0 * textureLod(bent_before_image, was.xy, 0.0).xyz - 1.0;
        bent = mix(bent_before, bent, weight);  // how far the camera has turned does not matter
#endif
#ifdef GLOAM_SKIPS
        if (works[sweeping].groups.z == 0u) {  // settled: there are no taps
            kept = vec4(texel, 0.0);
            means.x = texel.x;
#ifdef GLOAM_BENT_NORMALS
            bent = bent_before;
#endif
        }
#endif
    }
#ifdef GLOAM_MULTI_BOUNCE
    means.x = 1.0 - gloam_multi_bounce(means.x, vec3(parameters.albedo)).x;  // the history has none
#endif
    return visibility ? 1.0 - means.x : means.x;
}

#endif
