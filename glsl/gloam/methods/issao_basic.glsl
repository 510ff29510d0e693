// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ISSAO_BASIC_GLSL
#define GLOAM_METHODS_ISSAO_BASIC_GLSL

#include "gloam/gather/covering_disc.glsl"
#include "gloam/gather/fetch.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/issao.glsl"
#include "gloam/occlusion/layers.glsl"

// ISSAO before its attenuation (ISSAO-3, the left half of its figure 4). With the taps of issao, every surface within
// the radius counts its cosine, whatever its distance. The mean stands for the integral in the same way as in issao.

// All samples of one pixel in one frame (GloamEstimate).
GloamEstimate gloam_issao_basic(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamCoveringDisc disc = gloam_covering_disc(position, kernel.radius, kernel.angle, camera);
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        ivec2 at = gloam_covering_pixel(disc, kernel.first + i + 1u);
        float first = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, first, kernel.farthest)) continue;
        vec3 further = kernel.layers > 1 ? gloam_fetch_layers(at) : vec3(0.0);
        float most = 0.0;
        for (int layer = 0; layer < kernel.layers; ++layer) {
            float depth = gloam_layer_depth(first, further, layer);
            vec3 offset = gloam_footprint_position(disc.footprint, at, depth) - position;
            if (!(gloam_tap_sees(depth) && dot(offset, n) > kernel.bias)) continue;
            most = max(most, gloam_contribution_issao_basic(offset, n, kernel.radius));
        }
        sum += most;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
