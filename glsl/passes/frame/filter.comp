// SPDX-License-Identifier: MIT
#version 450
// The frame, last pass at full size: a mean over 3 x 3 pixels, weighted by the slices' weight and by depth. One
// invocation for each two pixels side by side: dispatch ceil(size / (32, 8)) groups, with GLOAM_MARKS as many as the
// list says (tile_list.glsl). Bindings are those of descriptor set 0; 2 and 3 are read in sequences.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
layout(local_size_x = 16, local_size_y = 8) in;

#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
layout(binding = 0) uniform highp usampler2D texel_image;  // of sweep.comp; nearest, clamped to the edge
layout(binding = 1, GLOAM_OUTPUT) uniform writeonly highp image2D result_image;  // occlusion, in [0, 1]
layout(binding = 2) uniform highp sampler2D before_image;
layout(binding = 3) uniform highp sampler2D depth_before_image;
layout(binding = 4, rgb10_a2) uniform writeonly highp image2D history_image;  // written in sequences
#ifdef GLOAM_BENT_NORMALS
layout(binding = 5) uniform highp sampler2D bend_image;                    // of sweep.comp; as its texels
layout(binding = 6, rgb10_a2) uniform writeonly highp image2D bent_image;  // written: (0.5 + 0.5 bent, 1)
layout(binding = 7) uniform highp sampler2D bent_before_image;  // of the frame before; bilinear, clamped
#endif

#include "passes/frame/texels.glsl"
#include "passes/frame/filter.glsl"

void main() {
    ivec2 first = ivec2(gl_GlobalInvocationID.xy) * ivec2(2, 1);
#ifdef GLOAM_MARKS
    uvec3 listing = listed(uvec2(2, 1));
    if (listing.z >= works[filtering].count) return;
    first = tile_at(tiles[listing.z].refined) + ivec2(listing.xy);
#endif
    read_texels(first);
    for (int x = 0; x < 2; ++x) {
        ivec2 place = ivec2(x, 0);
        float occlusion = accumulated(first + place, texel_at(place).depth, filtered(place), moved_around(ivec2(0)));
        imageStore(result_image, first + place, vec4(occlusion));
#ifdef GLOAM_BENT_NORMALS
        imageStore(bent_image, first + place, vec4(0.5 * bent + 0.5, 1.0));
#endif
        if (history) imageStore(history_image, first + place, kept);
    }
}
