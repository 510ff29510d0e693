// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_AKSOY_PHANEUF_GLSL
#define GLOAM_METHODS_AKSOY_PHANEUF_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/disc_taps.glsl"

// occlusion by the distance of surface points (METHOD-aksoy_phaneuf): `mean of 1 - |v| / R where v . n > beta` [Aksoy
// and Phaneuf 2011, CS-J].
GloamEstimate gloam_aksoy_phaneuf(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 tap = gloam_turn_disc(gloam_disc_point(kernel.first + i + 1u).xy, turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        float weight = gloam_contribution_aksoy_phaneuf(offset, n, kernel.radius, kernel.bias);
        sum += gloam_tap_sees(depth) ? max(weight, 0.0) : 0.0;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

// aksoy_phaneuf at two radii (Aksoy and Phaneuf 2011; CS-J). Half of the samples are within a quarter of the radius,
// for fine detail, and half within the whole radius. Both results are added and the sum is clamped. (The larger of
// the two would depend on the noise of a frame's few samples.)

// aksoy_phaneuf at two radii (METHOD-aksoy_phaneuf_two): `min(AO(R / 4) + AO(R), 1)` [Aksoy and Phaneuf 2011, CS-J].
// All samples of one pixel in one frame, as many at both radii. Parameters and result are those of gloam_aksoy_phaneuf.
GloamEstimate gloam_aksoy_phaneuf_two(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    GloamKernel broad = kernel;
    broad.first = kernel.first / 2u;
    broad.count = gloam_paired_samples(kernel.count) / 2u;
    GloamKernel fine = broad;
    fine.radius = 0.25 * kernel.radius;
    GloamEstimate far = gloam_aksoy_phaneuf(position, normal, camera, broad);
    GloamEstimate near = gloam_aksoy_phaneuf(position, normal, camera, fine);
    if (!(far.samples > 0.0)) return GLOAM_NO_ESTIMATE;
    return GloamEstimate(gloam_two_radii_sum(near.occlusion, far.occlusion), float(2u * broad.count), 1.0);
}

#endif
