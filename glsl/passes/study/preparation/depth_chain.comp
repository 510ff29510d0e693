// SPDX-License-Identifier: MIT
#version 450
// The depth chain of SAO, all levels in one pass: each texel copies one pixel of the full image, so no level depends on
// another. One invocation for each texel of level 1. Writes the depth in x, unchanged from the full image.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/sao_chain.glsl"

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    for (int level = 1; level <= GLOAM_LAST_TAP_LEVEL; ++level) {
        ivec2 size = gloam_depth_mip_size(parameters.size, level);
        if (texel.x >= size.x || texel.y >= size.y) return;
        float depth = gloam_fetch_depth(gloam_depth_mip_source(texel, parameters.size, level));
        imageStore(prepared_image, gloam_chain_texel(texel, level, parameters.size), vec4(depth));
    }
}
