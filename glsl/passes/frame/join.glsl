// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_JOIN_GLSL
#define GLOAM_PASSES_FRAME_JOIN_GLSL

// Filter and upsampling of the frame at half size, for compute and fragment shaders. They declare before it:
//   GloamFrameTexel texel_at(ivec2 place)   the texel at a place, counted from that of the pixel's block

#include "passes/frame/history.glsl"

// 1 over the relative bend of depth that counts as an edge, and over the difference that counts as another surface.
const vec2 inverse_tolerance = 1.0 / vec2(0.0075, 0.075);

// Sums of a pixel: of the occlusion and weight of the nearest texels, and of all, which count in pairs around it.
// odd: 0 for the first pixel of its block, else 1, in x and in y. depth: its own.
vec4 joined(ivec2 odd, float depth) {
    vec2 scale = inverse_tolerance / (usual_share(depth, parameters.usual, orthographic) * depth);
    vec2 inner = vec2(0.0);
    vec2 outer = vec2(0.0, 1e-4);
#ifdef GLOAM_BENT_NORMALS
    bends.xyz = vec3(1e-4 * 128.0 / 255.0);
#endif
    for (int y = 0; y <= 2; ++y) {
        for (int x = -1; x <= 2; ++x) {
            ivec2 other = odd - ivec2(x, y);
            vec2 tent = max(2.0 - abs(vec2(x, y) - 0.5 * vec2(odd)), 0.0);
            if (tent.x * tent.y == 0.0 || 4 * y + x < 4 * other.y + other.x) continue;
            GloamFrameTexel fore = texel_at(ivec2(x, y));
            GloamFrameTexel back = texel_at(other);
            float spatial = tent.x * tent.y * (other == ivec2(x, y) ? 0.5 : 1.0);  // the pixel's own texel is both
            vec2 near = spatial * gloam_near_pair(vec2(fore.depth, back.depth), depth, scale, 0.4);
            bool nearest = min(tent.x, tent.y) >= 1.5;
            vec2 sum = near.y * sums_of(back) + (near.x * sums_of(fore) + (nearest ? inner : outer));
            if (nearest) inner = sum;
            else outer = sum;
#ifdef GLOAM_BENT_NORMALS
            near *= vec2(fore.weight, back.weight);
            bends.xyz += near.x * bend_at(ivec2(x, y)) + near.y * bend_at(other);
#endif
        }
    }
#ifdef GLOAM_BENT_NORMALS
    bends.w = inner.y + outer.y;
#endif
    return vec4(inner, inner + outer) * vec2(1.0 / 255.0, 1.0).xyxy;
}

// Share of the texels around a block whose taps met what moved: 1 from a quarter on.
float moved_around() {
    uint moved = 0u;
    for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x) moved += texel_at(ivec2(x, y)).moved;
    return min(0.25 * float(moved), 1.0);
}

// A pixel beside a tile that is swept in full, as filter reads it there: so both sides of the border have a part of one
// another. A mean of many texels has the most weight that one can have.
uvec2 full_texel(float depth, vec4 sums) {
    return uvec2(gloam_frame_code(depth, sums.z / sums.w, 1.6), floatBitsToUint(depth));
}

// Whether a pixel of a tile has neighbours in another.
bool is_at_rim(ivec2 pixel) {
    ivec2 place = pixel + 1 & 7;
    return min(place.x, place.y) <= 1;
}

#endif
