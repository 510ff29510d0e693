// SPDX-License-Identifier: MIT
#version 450
// The frame, second pass: the horizon sweep (gloam/occlusion/sweep_pair.glsl) of each pixel, or of every second one in
// both directions. One invocation a pixel of what it writes.
//
// Define GLOAM_TEXELS as rg32ui for deep views (parameters.glsl); the default is r32ui.
// Dispatch ceil(size of binding 2 / (16, 8)) groups. Descriptor set 0:
//   0  r16f   depth of prepare.comp with its levels; nearest texel and level, clamped to the edge
//   1         normals as the engine stores them, any format; from depth: its depth, in x
//   2  texels  written: gloam/filter/frame_texel.glsl, and with two components the depth, for deep views
// With a list of tiles (tile_list.glsl) it dispatches as many groups as the list says.
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

#include "passes/frame/sweep.glsl"
#include "passes/frame/tile_list.glsl"

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
#ifdef GLOAM_TILES
    pixel = tile_at(gl_WorkGroupID.x) + ivec2(gl_LocalInvocationID.xy);
#endif
    imageStore(texel_image, pixel, texel_of(pixel).xyxy);
#ifdef GLOAM_BENT_NORMALS
    blocked.z -= parameters.view_from_world[2].w * blocked.z;  // in the view space of the engine
    imageStore(bend_image, pixel, vec4((128.0 - 127.0 * blocked) / 255.0, 1.0));
#endif
}
