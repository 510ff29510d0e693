// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_POISSON_GLSL
#define GLOAM_METHODS_POISSON_GLSL

#include "gloam/occlusion/blocked.glsl"
#include "gloam/occlusion/ray_gather.glsl"
#include "gloam/sampling/poisson.glsl"
#include "gloam/sampling/poisson_disc.glsl"
#include "gloam/sampling/radical_inverse.glsl"
#include "gloam/sampling/rotation.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_ray_samples(count, method.steps)

// Poisson rays (Sourimant et al. 2011; CS-J): points of a Poisson disc lifted to the half ball are cosine-weighted directions, each of which is
// marched until something blocks it within the radius. No falloff. Once through the disc, the next round is turned by another angle.
// Reads range (what is further in front of a step is another object) and steps.

GloamRay gloam_method_ray(uint index, mat3 frame, GloamKernel kernel, GloamMethod method) {
    float turn = 6.283185307 * gloam_radical_inverse_base2(index / 64u);
    vec2 disc = gloam_rotate_disc(gloam_poisson_disc(index), kernel.angle + turn);
    float jitter = fract(gloam_radical_inverse(index + 1u, 3u) + gloam_unit_interval(kernel.angle / 6.283185307));
    return GloamRay(frame * gloam_hemisphere_lift(disc), jitter, vec2(0.0));
}

vec2 gloam_method_ray_step(GloamRay ray, GloamRayTap tap, vec3 normal, GloamKernel kernel, GloamMethod method) {
    return vec2(max(ray.seen.x, gloam_sample_blocked(tap.depth, tap.buffer_depth, kernel.bias, method.range)), 0.0);
}

vec2 gloam_method_ray_end(GloamRay ray, vec3 normal, GloamMethod method) {
    return vec2(ray.seen.x, 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_ray_gather(position, normal, camera, kernel, method);
}

#endif
