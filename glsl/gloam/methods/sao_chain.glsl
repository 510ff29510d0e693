// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SAO_CHAIN_GLSL
#define GLOAM_METHODS_SAO_CHAIN_GLSL

#include "gloam/methods/sao.glsl"

// SAO with its depth chain in an image (preparation/depth_chain.comp), as in the paper. Far taps read neighbouring
// texels of a small image instead of pixels that are far apart. The result equals that of sao to the bit, with one
// exception: far taps do not detect moving objects.

// Where in that image a texel of a level lies: level 1 at the upper left, the others in a column to its right.
// texel: inside its level, from 1. size: of the full image, pixels.
ivec2 gloam_chain_texel(ivec2 texel, int level, ivec2 size) {
    if (level <= 1) return texel;
    ivec2 at = texel + ivec2(gloam_depth_mip_size(size, 1).x, 0);
    for (int l = 2; l < level; ++l) at.y += gloam_depth_mip_size(size, l).y;
    return at;
}

// sao, far taps from an image of the depth chain (METHOD-sao_chain): `as gloam_sao` [McGuire, Mara and Luebke 2012,
// CS-Q].
// gloam_fetch_prepared: levels 1 to 5 of the chain, in x (gloam_chain_texel).
GloamEstimate gloam_sao_chain(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamSao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sao_turn(kernel);
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 tap = gloam_turn_disc(gloam_spiral_point(int(i), int(kernel.count), GLOAM_SAO_TURNS), turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        ivec2 apart = abs(at - footprint.pixel);
        int level = gloam_depth_mip_level(float(max(apart.x, apart.y)), settings.mip_distance, GLOAM_LAST_TAP_LEVEL);
        ivec2 texel = gloam_depth_mip_pixel(at, camera.size, level);
        if (level > 0) at = gloam_depth_mip_source(texel, camera.size, level);
        float depth =
            level > 0 ? gloam_fetch_prepared(gloam_chain_texel(texel, level, camera.size)).x : gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        if (gloam_tap_sees(depth)) sum += gloam_sao_contribution(offset, n, kernel, settings);
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
