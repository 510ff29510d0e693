// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DISC_PROXY_GLSL
#define GLOAM_METHODS_DISC_PROXY_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/proxies.glsl"

// Discs in the place of pixels (Bunnell, GPU Gems 2, applied to visible surfaces; CS-S). Each pixel within the radius
// is a disc with the area and normal of the surface there. It blocks A / (A + pi D^2) times both cosines. This is the
// exact cosine-weighted occlusion up to the radius, for surfaces that do not hide one another. A surface through the
// point itself is seen edge-on from there and blocks nothing, so a groove is open along its line.
struct GloamDiscProxy {
    float intensity;  // factor of the sum
};

// Contribution of the surface at a pixel as a disc with the area that the pixel covers there (CS-S).
// at: inside the image. position: of the shaded point, view space, world units. normal: of it, unit. kernel: of it the
// radius and the bias count. axes: half-axes of the radius at the shaded point's depth, pixels.
// Returns a contribution in [0, 1]; 0 where the pixel shows nothing, for what lies beyond the radius and for what is
// no higher than the bias over the tangent plane. Error: 1e-6 of the disc's own.
float gloam_disc_piece(GloamFootprint footprint, ivec2 at, vec3 position, vec3 normal, GloamKernel kernel, vec2 axes) {
    float depth = gloam_fetch_depth(at);
    vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
    bool counts = gloam_tap_sees(depth) && dot(offset, offset) <= kernel.radius * kernel.radius &&
                  dot(offset, normal) > kernel.bias;
    if (!counts) return 0.0;
    // Half-axes of the radius there, pixels: so large is a pixel in the world.
    vec2 size = axes * (footprint.orthographic ? 1.0 : -position.z / depth);
    size = kernel.radius / size;
    vec3 emitter = gloam_safe_normalize(gloam_fetch_normal(at), vec3(0.0));
    vec3 ray = vec3(footprint.orthographic ? vec2(0.0) : gloam_footprint_ray(footprint, at), -1.0);
    // At the outline of a surface, where the cosine is less, a pixel would stand for more area than there is.
    float area = size.x * size.y / max(-dot(emitter, ray), 0.05);
    return gloam_contribution_disc_proxy_cosine(offset, normal, emitter, area, 1.0);
}

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
