// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_UNREAL_GLSL
#define GLOAM_METHODS_UNREAL_GLSL

#include "gloam/occlusion/angle_based.glsl"
#include "gloam/occlusion/ray_gather.glsl"
#include "gloam/sampling/circle.glsl"
#include "gloam/sampling/radical_inverse.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_ray_samples(count, method.steps)

// The later shader of Unreal Engine 4 (CS-P): along both sides of mirrored directions of the image the largest sat(epsilon (v . n) / (v . v)) of
// the steps; a side leaves (1 - occ)^2 open, of which the mean is taken. What is near counts more than what stands high: along the
// line of a groove its rising side is blocked but in the line's own direction.
// Reads epsilon (0.8 in the engine: the distance up to which a blocker straight above counts fully), intensity and steps. The engine's power is
// the remap's c.

GloamRay gloam_method_ray(uint index, mat3 frame, GloamKernel kernel, GloamMethod method) {
    uint pair = index / 2u + 1u;
    float turned = gloam_unit_interval(kernel.angle / 6.283185307);
    vec2 direction = gloam_circle_point(0.5 * fract(gloam_radical_inverse_base2(pair) + turned));
    if ((index & 1u) == 1u) direction = -direction;
    return GloamRay(vec3(direction, 0.0), fract(gloam_radical_inverse(pair, 3u) + turned), vec2(0.0));
}

vec2 gloam_method_ray_step(GloamRay ray, GloamRayTap tap, vec3 normal, GloamKernel kernel, GloamMethod method) {
    if (!(dot(tap.offset, normal) > kernel.bias)) return ray.seen;
    return vec2(max(ray.seen.x, gloam_contribution_unreal(tap.offset, normal, method.epsilon)), 0.0);
}

vec2 gloam_method_ray_end(GloamRay ray, vec3 normal, GloamMethod method) {
    return vec2(1.0 - gloam_unreal_side(ray.seen.x), 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    vec2 sum = gloam_ray_gather(position, normal, camera, kernel, method);
    float visibility = gloam_unreal_visibility(1.0 - gloam_weighted_ratio(sum), 1.0, min(method.intensity, 1.0));
    return vec2(sum.y * (1.0 - visibility), sum.y);
}

#endif
