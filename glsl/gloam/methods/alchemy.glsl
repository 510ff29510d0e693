// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ALCHEMY_GLSL
#define GLOAM_METHODS_ALCHEMY_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/disc_taps.glsl"

// Alchemy ambient obscurance (McGuire et al. 2011; CS-3.6 to 3.10): surface points under a disc. Each counts 2 sigma
// (v . n - bias) / (v . v + epsilon^2). Its falloff is 0 for touching geometry, rises up to the distance sigma, and
// beyond falls as the inverse of the distance.
struct GloamAlchemy {
    float epsilon;    // world units, here small: it bounds what one tap counts
    float intensity;  // sigma as a share of the radius
};

// occlusion by surface points under a disc (METHOD-alchemy): `mean of 2 sigma max(v . n - beta, 0) / (v . v + epsilon)`
// [McGuire et al. 2011, CS-3.10].
GloamEstimate gloam_alchemy(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamAlchemy settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sigma = settings.intensity * kernel.radius;
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 tap = gloam_turn_disc(gloam_disc_point(kernel.first + i + 1u).xy, turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        float counted =
            gloam_contribution_alchemy(offset, n, kernel.bias, settings.epsilon * settings.epsilon, 2.0 * sigma);
        sum += gloam_tap_sees(depth) ? counted : 0.0;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
