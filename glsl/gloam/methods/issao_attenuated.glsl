// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ISSAO_ATTENUATED_GLSL
#define GLOAM_METHODS_ISSAO_ATTENUATED_GLSL

#include "gloam/gather/covering_disc.glsl"
#include "gloam/gather/fetch.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/issao.glsl"
#include "gloam/occlusion/layers.glsl"

// ISSAO with its attenuation by distance (ISSAO-4 and ISSAO-5, the right half of its figure 4). With the taps of
// issao, every surface within the radius counts Q(|v|) times its cosine. The mean stands for the integral in the same
// way as in issao. Both methods agree where |v| is large against mu and the bias small against v . n.
struct GloamIssaoAttenuated {
    float epsilon;    // mu, world units: bounds the distance from below
    float intensity;  // phi as a share of the radius
};

// All samples of one pixel in one frame (GloamEstimate).
GloamEstimate gloam_issao_attenuated(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                     GloamIssaoAttenuated settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamCoveringDisc disc = gloam_covering_disc(position, kernel.radius, kernel.angle, camera);
    float phi = settings.intensity * kernel.radius;
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
            float q = gloam_contribution_issao_attenuated(offset, n, kernel.radius, phi, settings.epsilon);
            most = max(most, q);
        }
        sum += most;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
