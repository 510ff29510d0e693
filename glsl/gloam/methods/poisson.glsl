// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_POISSON_GLSL
#define GLOAM_METHODS_POISSON_GLSL

#include "gloam/gather/method.glsl"

// Poisson rays (Sourimant et al. 2011; CS-J). Points of a Poisson disc, lifted to the half ball, are cosine-weighted
// directions. Each is marched until something blocks it within the radius. There is no falloff. After all points of
// the disc, the next round uses them rotated by another angle.
struct GloamPoisson {
    float range;  // world units: what is further in front of a step is another object
    uint steps;   // of a ray, at least 1
};

// blocked rays of a lifted Poisson disc (METHOD-poisson): `share of the rays that are blocked` [Sourimant et al. 2011,
// CS-J].
// All samples of one pixel in one frame, by rays.
GloamEstimate gloam_poisson(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamPoisson settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    mat3 frame = gloam_tangent_frame(normalize(normal));
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    uint steps = max(settings.steps, 1u);
    uint rays = gloam_whole_samples(kernel.count, steps) / steps;
    float occluded = 0.0;
    for (uint i = 0u; i < rays; ++i) {
        uint index = kernel.first / steps + i;
        float round_turn = GLOAM_TAU * gloam_radical_inverse_base2(index / 64u);  // of the disc's 64 points
        vec3 direction =
            frame * gloam_hemisphere_lift(gloam_rotate_disc(gloam_poisson_disc(index), kernel.angle + round_turn));
        float jitter = fract(gloam_halton_point(index + 1u).y + gloam_unit_interval(kernel.angle / GLOAM_TAU));
        bool blocked = false;
        for (uint k = 0u; k < steps && !blocked; ++k) {
            vec3 at = gloam_eye_march(position, direction, kernel.radius, k, steps, jitter);
            ivec2 pixel = gloam_footprint_seen(footprint, at);
            float depth = gloam_fetch_depth(pixel);
            if (!(at.z < 0.0) || pixel == footprint.pixel) continue;
            blocked = gloam_sample_blocked(gloam_footprint_plane_depth(footprint, pixel, at, frame[2]), depth,
                                           kernel.bias, settings.range);
        }
        occluded += blocked ? 1.0 : 0.0;
    }
    return gloam_estimate(occluded, float(rays), rays * steps);
}

#endif
