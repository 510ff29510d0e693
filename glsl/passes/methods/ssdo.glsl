// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SSDO_GLSL
#define GLOAM_METHODS_SSDO_GLSL

#include "gloam/occlusion/blocked.glsl"
#include "gloam/occlusion/ray_gather.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/hemisphere.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/shading/directional_occlusion.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_ray_samples(count, method.steps)

// The direct half of directional occlusion (Ritschel, Grosch and Seidel 2009; CS-D) under light of 1 from everywhere: what of it does not
// arrive. One point of uniform distance along each of the directions, which are uniform and count 2 w . n: the cosine-weighted occlusion
// with the linear falloff, for a scene that is solid behind what the eye sees. With more steps than 1 the nearest blocker of that many points
// counts, and the falloff goes towards none. Where everything is blocked the mean of 2 w . n is 1 in the mean only.
// Reads range, as the points of a half ball do, and steps.

GloamRay gloam_method_ray(uint index, mat3 frame, GloamKernel kernel, GloamMethod method) {
    vec3 halton = gloam_halton_3d(index + 1u);
    // The map's radius is its second coordinate: 1 for a direction.
    vec3 direction = gloam_rotate_hemisphere(gloam_hemisphere_uniform(vec3(halton.x, 1.0, halton.z)), kernel.angle);
    return GloamRay(frame * direction, halton.y, vec2(0.0));
}

vec2 gloam_method_ray_step(GloamRay ray, GloamRayTap tap, vec3 normal, GloamKernel kernel, GloamMethod method) {
    return vec2(max(ray.seen.x, gloam_sample_blocked(tap.depth, tap.buffer_depth, kernel.bias, method.range)), 0.0);
}

vec2 gloam_method_ray_end(GloamRay ray, vec3 normal, GloamMethod method) {
    return vec2(gloam_ssdo_direct(ray.direction, normal, vec3(1.0), ray.seen.x).x, 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_ray_gather(position, normal, camera, kernel, method);
}

#endif
