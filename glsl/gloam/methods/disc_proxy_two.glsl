// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DISC_PROXY_TWO_GLSL
#define GLOAM_METHODS_DISC_PROXY_TWO_GLSL

#include "gloam/methods/disc_proxy.glsl"

// disc_proxy in two passes (Bunnell, GPU Gems 2; CS-S). The first pass is disc_proxy for every pixel
// (preparation/disc_visibility.comp). In the second, here, each disc blocks in proportion to its own visibility. A
// disc in the shadow of another is behind it for most points, so what both block is counted once. The first pass
// takes half of the samples. Its result is that of one frame: with few samples it is noisy, and it is clamped.

// Samples of one of the passes: half of those asked for.
GloamKernel gloam_disc_pass_kernel(GloamKernel kernel) {
    GloamKernel half_of = kernel;
    half_of.first = kernel.first / 2u;
    half_of.count = gloam_paired_samples(kernel.count) / 2u;
    return half_of;
}

// disc_proxy, each disc by its own visibility (METHOD-disc_proxy_two): `intensity times the sum of 2 rho_i M v A / (A +
// pi D^2) cos cos` [Bunnell 2005, CS-S].
// All samples of one pixel in one frame, the prepared ones counted; an odd number is taken as the even one above it.
// gloam_fetch_prepared: the visibility of each pixel's disc, in x. Returns an occlusion no larger than that of
// gloam_disc_proxy by as many samples. Error: as there.
GloamEstimate gloam_disc_proxy_two(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                   GloamDiscProxy settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamKernel second = gloam_disc_pass_kernel(kernel);
    GloamFootprint footprint = gloam_footprint(position, second.radius, camera);
    vec2 axes = footprint.reach * footprint.size;
    float pixels = GLOAM_PI * axes.x * axes.y;
    vec2 turn = gloam_sincos_turns(gloam_turns(second.angle));
    float sum = 0.0;
    for (uint i = 0u; i < second.count; ++i) {
        vec3 random = gloam_halton_point(second.first + i + 1u);
        vec2 tap = gloam_turn_disc(random.y * gloam_circle_point(random.x), turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        if (at == footprint.pixel) continue;
        float piece = gloam_disc_piece(footprint, at, position, n, second, axes);
        if (!(piece > 0.0)) continue;
        sum += 2.0 * random.y * pixels * piece * gloam_unit_interval(gloam_fetch_prepared(at).x);
    }
    return gloam_estimate(settings.intensity * sum, float(second.count), 2u * second.count);
}

#endif
