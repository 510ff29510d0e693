// SPDX-License-Identifier: MIT
#version 450
// The frame, last pass at half size: filter and upsampling in one. A pixel takes the 3 x 3 to 4 x 4 texels around it,
// weighted by a tent, by the slices' weight and by depth. One invocation for each 2 x 2 pixels of the view: dispatch
// ceil(ceil(size / 2) / (16, 8)) groups. Bindings are those of descriptor set 0; 3 and 4 are read in sequences.
//
// Define GLOAM_OUTPUT as r16f or r8 for an output of fewer bits; the default is r32f.
// With GLOAM_MARKS it dispatches as many groups as its list says (tile_list.glsl), and writes what filter.comp reads
// around its tiles: at binding GLOAM_OTHER_TEXELS the texels of the view's size, behind it their bends.
layout(local_size_x = 16, local_size_y = 8) in;

#ifndef GLOAM_OUTPUT
#define GLOAM_OUTPUT r32f
#endif
#ifndef GLOAM_TEXELS
#define GLOAM_TEXELS r32ui
#endif
layout(binding = 0) uniform highp usampler2D texel_image;  // of sweep.comp, every second pixel; nearest, clamped
layout(binding = 1) uniform highp sampler2D depth_image;   // of prepare.comp; likewise
layout(binding = 2, GLOAM_OUTPUT) uniform writeonly highp image2D result_image;  // occlusion, in [0, 1]
layout(binding = 3) uniform highp sampler2D before_image;
layout(binding = 4) uniform highp sampler2D depth_before_image;
layout(binding = 5, rgb10_a2) uniform writeonly highp image2D history_image;  // written in sequences
#ifdef GLOAM_BENT_NORMALS
layout(binding = 6) uniform highp sampler2D bend_image;                    // of sweep.comp; as its texels
layout(binding = 7, rgb10_a2) uniform writeonly highp image2D bent_image;  // written: (0.5 + 0.5 bent, 1)
layout(binding = 8) uniform highp sampler2D bent_before_image;  // of the frame before; bilinear, clamped
#endif

#ifdef GLOAM_MARKS
layout(binding = GLOAM_OTHER_TEXELS, GLOAM_TEXELS) uniform writeonly highp uimage2D full_texel_image;
#ifdef GLOAM_BENT_NORMALS
layout(binding = GLOAM_OTHER_TEXELS + 1, rgba8) uniform writeonly highp image2D full_bend_image;
#endif
#endif

#include "passes/frame/texels.glsl"
#include "passes/frame/join.glsl"

void main() {
    ivec2 block = ivec2(gl_GlobalInvocationID.xy);
#ifdef GLOAM_MARKS
    uvec3 listing = listed(uvec2(2));
    if (listing.z >= works[joining].count) return;
    block = (tile_at(tiles[listing.z].joined) + ivec2(listing.xy)) / 2;
#endif
    read_texels(block);
    vec4 own = abs(textureGather(depth_image, vec2(2 * block + 1) * parameters.inverse_size)).wzxy;  // by rows
    for (int i = 0; i < 4; ++i) {
        ivec2 odd = ivec2(i % 2, i / 2);
        ivec2 pixel = 2 * block + odd;
        vec4 sums = joined(odd, own[i]);
#ifdef GLOAM_MARKS
        if (is_at_rim(pixel)) imageStore(full_texel_image, pixel, full_texel(own[i], sums).xyxy);
#ifdef GLOAM_BENT_NORMALS
        if (is_at_rim(pixel)) imageStore(full_bend_image, pixel, vec4(bends.xyz / bends.w, 1.0));
#endif
#endif
        imageStore(result_image, pixel, vec4(accumulated(pixel, own[i], sums, moved_around())));
#ifdef GLOAM_BENT_NORMALS
        imageStore(bent_image, pixel, vec4(0.5 * bent + 0.5, 1.0));
#endif
        if (history) imageStore(history_image, pixel, kept);
    }
}
