// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_MARK_GLSL
#define GLOAM_PASSES_FRAME_MARK_GLSL

// Which tiles of 8 x 8 pixels half size does not suffice in, for compute and fragment shaders. They declare before it:
//   uvec4 four_texels(vec2 at)   texels of the sweep of every second pixel, the four around a place of their image

#include "gloam/filter/frame_texel.glsl"
#include "passes/frame/parameters.glsl"

struct MarkParameters {
    vec2 inverse_texels;  // 1 over the size of the texels
    float least;          // deviation of the occlusion from which on a tile is swept in full
};
FRAME_PARAMETERS(MarkParameters)

// By its 4 x 4 texels and those around them: so little varies where tiles of both kinds meet.
bool is_marked(ivec2 tile) {
    vec4 sum = vec4(0.0);
    vec4 squares = vec4(0.0);
    for (int i = 0; i < 9; ++i) {
        ivec2 place = 4 * tile + 2 * ivec2(i % 3, i / 3);
        vec4 occlusion = vec4(four_texels(vec2(place) * parameters.inverse_texels) >> 16u & 0xFFu);
        sum += occlusion;
        squares += occlusion * occlusion;
    }
    const vec4 all = vec4(1.0);
    return gloam_tile_deviation(uint(dot(sum, all)), uint(dot(squares, all)), 36u) >= 255.0 * parameters.least;
}

#endif
