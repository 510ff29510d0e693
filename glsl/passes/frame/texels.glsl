// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_TEXELS_GLSL
#define GLOAM_PASSES_FRAME_TEXELS_GLSL

// The sweep's texels around those that an invocation of filter.comp or join.comp is for, each unpacked once. Shaders
// declare before it:
//   usampler2D texel_image   texels of sweep.comp; nearest, clamped to the edge

#include "passes/frame/history.glsl"

GloamFrameTexel texels[4][4];

// From -1 to 2, in x and in y.
GloamFrameTexel texel_at(ivec2 place) {
    return texels[place.y + 1][place.x + 1];
}

// Reads them, four by a gather. first: the texel at place 0.
void read_texels(ivec2 first) {
    vec2 corner = vec2(first) * parameters.inverse_texels;
#ifdef GLOAM_BENT_NORMALS
    first_bend = (vec2(first) + 0.5) * parameters.inverse_texels;
#endif
    for (int y = 0; y < 4; y += 2) {
        for (int x = 0; x < 4; x += 2) {
            vec2 at = corner + vec2(x, y) * parameters.inverse_texels;
            uvec4 four = textureGather(texel_image, at).wzxy;  // by rows
            uvec4 depths = deep ? textureGather(texel_image, at, 1).wzxy : four;
            for (int i = 0; i < 4; ++i) texels[y + i / 2][x + i % 2] = texel_from(uvec2(four[i], depths[i]));
        }
    }
}

#endif
