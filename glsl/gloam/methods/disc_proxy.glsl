// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DISC_PROXY_GLSL
#define GLOAM_METHODS_DISC_PROXY_GLSL

#include "gloam/gather/disc_piece.glsl"
#include "gloam/gather/method.glsl"

// Discs in the place of pixels (Bunnell, GPU Gems 2, applied to visible surfaces; CS-S). Each pixel within the radius
// is a disc with the area and normal of the surface there. It blocks A / (A + pi D^2) times both cosines. This is the
// exact cosine-weighted occlusion up to the radius, for surfaces that do not hide one another. A surface through the
// point itself is seen edge-on from there and blocks nothing, so a groove is open along its line.
struct GloamDiscProxy {
    float intensity;  // factor of the sum
};

// pixels around as discs of their surface (METHOD-disc_proxy): `intensity times the sum of 2 rho_i M A / (A + pi D^2)
// cos cos` [Bunnell 2005, CS-S].
// The density of taps is 1 / distance from the pixel, because a piece counts by the inverse square of its distance.
// They are weighted so that their mean is the sum over all pixels of the disc but the shaded one, times the intensity.
// Pieces behind one another all count. The sum is clamped; where many pieces lie behind one another it is too large.
// Error: 2e-6 of each tap's share of the sum, but for taps within rounding of a pixel's border.
GloamEstimate gloam_disc_proxy(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                               GloamDiscProxy settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 axes = footprint.reach * footprint.size;
    float pixels = GLOAM_PI * axes.x * axes.y;
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec3 random = gloam_halton_point(kernel.first + i + 1u);
        vec2 tap = gloam_turn_disc(random.y * gloam_circle_point(random.x), turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        if (at == footprint.pixel) continue;
        sum += 2.0 * random.y * pixels * gloam_disc_piece(footprint, at, position, n, kernel, axes);
    }
    return gloam_estimate(settings.intensity * sum, float(kernel.count), kernel.count);
}

#endif
