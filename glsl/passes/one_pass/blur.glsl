// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_ONE_PASS_BLUR_GLSL
#define GLOAM_PASSES_ONE_PASS_BLUR_GLSL

// Of what engine_occlusion() gives, by engine_depth().

#include "gloam/filter/frame_texel.glsl"

layout(constant_id = 7) const int stride = 1;  // pixels of the depth from one that is drawn to the next

// Mean of five pixels in a column or a row, as the filter of the frame takes nine. size: of what is drawn, pixels.
float blurred(ivec2 pixel, ivec2 size, bool in_column) {
    float own = engine_depth(stride * pixel, 0);
    vec2 sum = vec2(engine_occlusion(pixel), 1.0);
    if (!(own > 0.0 && own < 1e30)) return sum.x;
    vec2 scale = 1.0 / (vec2(0.0025, 0.15) * own);
    for (int i = 1; i <= 2; ++i) {
        ivec2 offset = in_column ? ivec2(0, i) : ivec2(i, 0);
        ivec2 fore = min(pixel + offset, size - 1);
        ivec2 back = max(pixel - offset, 0);
        vec2 depths = vec2(engine_depth(stride * fore, 0), engine_depth(stride * back, 0));
        vec2 near = gloam_near_pair(depths, own, scale, 0.2);
        sum += near.x * vec2(engine_occlusion(fore), 1.0) + near.y * vec2(engine_occlusion(back), 1.0);
    }
    return sum.x / sum.y;
}

#endif
