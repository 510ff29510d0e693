// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_FILTER_GLSL
#define GLOAM_PASSES_FRAME_FILTER_GLSL

// The filter of the frame at full size, for compute and fragment shaders. They declare before it:
//   GloamFrameTexel texel_at(ivec2 place)   the texel at a place, counted from the first that an invocation is for

#include "passes/frame/history.glsl"

// 1 over the relative bend of depth that counts as an edge, and over the difference that counts as another surface.
const vec2 inverse_tolerance = 1.0 / vec2(0.0025, 0.15);

// Sums of the pixel at a place: of its own occlusion and weight, and of all. Texels count in pairs around it.
vec4 filtered(ivec2 middle) {
    GloamFrameTexel own = texel_at(middle);
    vec2 mine = sums_of(own);
    vec2 sum = mine + vec2(0.0, 1e-4);
    vec2 scale = inverse_tolerance / (usual_share(own.depth, parameters.usual, orthographic) * own.depth);
#ifdef GLOAM_BENT_NORMALS
    bends = (own.weight + 1e-4) * vec4(bend_at(middle), 1.0);
#endif
    for (int y = 0; y <= 1; ++y) {
        for (int x = -1; x <= 1; ++x) {
            if (y == 0 && x <= 0) continue;
            GloamFrameTexel fore = texel_at(middle + ivec2(x, y));
            GloamFrameTexel back = texel_at(middle - ivec2(x, y));
            vec2 near = gloam_near_pair(vec2(fore.depth, back.depth), own.depth, scale, 0.2);
            sum += near.x * sums_of(fore) + near.y * sums_of(back);
#ifdef GLOAM_BENT_NORMALS
            near *= vec2(fore.weight, back.weight);
            bends.xyz += near.x * bend_at(middle + ivec2(x, y)) + near.y * bend_at(middle - ivec2(x, y));
            bends.w += near.x + near.y;
#endif
        }
    }
    return vec4(mine, sum) * vec2(1.0 / 255.0, 1.0).xyxy;
}

// Share of the texels around two pixels side by side whose taps met what moved: 1 from a half on. first: place of the
// first of the two.
float moved_around(ivec2 first) {
    uint moved = 0u;
    for (int y = -1; y <= 1; ++y)
        for (int x = 0; x <= 1; ++x) moved += texel_at(first + ivec2(x, y)).moved;
    return min(float(moved) * (1.0 / 3.0), 1.0);
}

#endif
