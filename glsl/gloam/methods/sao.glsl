// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SAO_GLSL
#define GLOAM_METHODS_SAO_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/disc_taps.glsl"
#include "gloam/sampling/depth_mip.glsl"

// Scalable ambient obscurance (McGuire, Mara and Luebke 2012): surface points on a spiral under a disc, dense near the
// pixel. Far points are read from a depth chain (mip_distance 16). Each frame rotates the spiral by another angle.
struct GloamSao {
    float epsilon;       // world units: bounds what a near tap counts
    float intensity;     // sigma as a share of the radius, which the paper has at 1 m
    float mip_distance;  // pixels from which taps read level 1 of the depth chain, twice as far level 2, and so on; 0:
                         // none does
};

const int GLOAM_SAO_TURNS = 7;  // of the spiral

// (cos, sin) of the rotation of the spiral: of the pixel's angle and the frame's.
vec2 gloam_sao_turn(GloamKernel kernel) {
    uint frame = kernel.first / max(kernel.count, 1u);
    return gloam_sincos_turns(gloam_turns(kernel.angle) + gloam_radical_inverse_base2(frame));
}

// What the surface at an offset counts (gloam_contribution_sao).
float gloam_sao_contribution(vec3 offset, vec3 normal, GloamKernel kernel, GloamSao settings) {
    return gloam_contribution_sao(offset, normal, kernel.radius, kernel.bias, settings.epsilon * settings.epsilon,
                                  5.0 * settings.intensity * kernel.radius);
}

// occlusion by surface points on a spiral (METHOD-sao): `mean of 5 sigma (1 - v . v / R^2)^3 max(v . n - beta, 0) / (v
// . v + epsilon)` [McGuire, Mara and Luebke 2012, CS-Q].
GloamEstimate gloam_sao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamSao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sao_turn(kernel);
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 tap = gloam_turn_disc(gloam_spiral_point(int(i), int(kernel.count), GLOAM_SAO_TURNS), turn);
        ivec2 at =
            gloam_tap_pixel(gloam_footprint_pixel(footprint, tap), footprint.pixel, camera.size, settings.mip_distance);
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        if (gloam_tap_sees(depth)) sum += gloam_sao_contribution(offset, n, kernel, settings);
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
