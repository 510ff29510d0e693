// SPDX-License-Identifier: MIT
#version 450
// The frame, second pass: the horizon sweep (gloam/occlusion/sweep_pair.glsl) of each pixel, or of every second one in
// both directions. One invocation a pixel of what it writes: dispatch ceil(size of binding 2 / (16, 8)) groups.
// Bindings are those of descriptor set 0; sweep.glsl says what 0 and 1 are.
//
// Define GLOAM_TEXELS as rg32ui for deep views (parameters.glsl), whose second component is the depth; the default is
// r32ui.
// With GLOAM_SKIPS it dispatches as many groups as its list says (tile_list.glsl). With GLOAM_MARKS, too: it then
// sweeps what mark.comp has marked, for join.comp beside these tiles also the texels of every second pixel: at binding
// GLOAM_OTHER_TEXELS, and behind it their bends.
#ifndef GLOAM_TEXELS
#define GLOAM_TEXELS r32ui
#endif
layout(local_size_x = 16, local_size_y = 8) in;

layout(binding = 0) uniform highp sampler2D depth_image;
layout(binding = 1) uniform highp sampler2D normal_image;
layout(binding = 2, GLOAM_TEXELS) uniform writeonly highp uimage2D texel_image;
#ifdef GLOAM_BENT_NORMALS
layout(binding = 3, rgba8) uniform writeonly highp image2D bend_image;  // written: of each texel
#endif

#ifdef GLOAM_MARKS
layout(binding = GLOAM_OTHER_TEXELS, GLOAM_TEXELS) uniform writeonly highp uimage2D half_texel_image;
#ifdef GLOAM_BENT_NORMALS
layout(binding = GLOAM_OTHER_TEXELS + 1, rgba8) uniform writeonly highp image2D half_bend_image;
#endif
#endif

#include "passes/frame/sweep.glsl"
#include "passes/frame/tile_list.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
#ifdef GLOAM_TILES
    uvec3 own = listed(uvec2(stride));
#ifdef GLOAM_MARKS
    if (own.z >= works[refining].count) return;
    pixel = tile_at(tiles[own.z].refined) + ivec2(own.xy);
#else
    if (own.z >= works[sweeping].count) return;
    pixel = (tile_at(tiles[own.z].swept) + ivec2(own.xy)) / stride;
#endif
#endif
    uvec4 texel = texel_of(pixel).xyxy;
    imageStore(texel_image, pixel, texel);
#ifdef GLOAM_MARKS
    if (((pixel.x | pixel.y) & 1) == 0) imageStore(half_texel_image, pixel / 2, texel);
#endif
#ifdef GLOAM_BENT_NORMALS
    vec4 bend = bend_texel();
    imageStore(bend_image, pixel, bend);
#ifdef GLOAM_MARKS
    if (((pixel.x | pixel.y) & 1) == 0) imageStore(half_bend_image, pixel / 2, bend);
#endif
#endif
}
