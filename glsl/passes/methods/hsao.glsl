// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_HSAO_GLSL
#define GLOAM_METHODS_HSAO_GLSL

#include "gloam/geometry/into_slice.glsl"
#include "gloam/occlusion/hbao.glsl"
#include "gloam/occlusion/ray_gather.glsl"
#include "gloam/sampling/circle.glsl"
#include "gloam/sampling/radical_inverse.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_ray_samples(count, method.steps)

// Horizon-split ambient occlusion (Dimitrov, Bavoil and Sainz 2008; CS-C2), the precursor of hbao: the same horizons from rays that are marched
// in eye space, parallel to the image, in steps of one length; each step is projected. Two rays, opposite, are one slice. With the same taps
// the result is that of hbao, up to intensities that take a single slice beyond 1.
// Reads angle_bias, intensity (contrast) and steps.

GloamRay gloam_method_ray(uint index, mat3 frame, GloamKernel kernel, GloamMethod method) {
    uint slice = index / 2u + 1u;
    float turned = gloam_unit_interval(kernel.angle / 6.283185307);
    vec2 direction = gloam_circle_point(0.5 * fract(gloam_radical_inverse_base2(slice) + turned));
    if ((index & 1u) == 1u) direction = -direction;
    vec2 start = gloam_hbao_start(gloam_tangent_elevation(frame[2], direction), method.angle_bias);
    return GloamRay(vec3(direction, 0.0), fract(gloam_radical_inverse(slice, 3u) + turned), start);
}

vec2 gloam_method_ray_step(GloamRay ray, GloamRayTap tap, vec3 normal, GloamKernel kernel, GloamMethod method) {
    // Moved into a slice that nearly lies in the tangent plane, it would no longer be as high.
    if (!(dot(tap.offset, normal) > kernel.bias)) return ray.seen;
    vec3 axis = vec3(ray.direction.y, -ray.direction.x, 0.0);
    return gloam_hbao_step(ray.seen, gloam_into_slice(tap.offset, axis, normal), kernel.radius);
}

vec2 gloam_method_ray_end(GloamRay ray, vec3 normal, GloamMethod method) {
    return vec2(ray.seen.y, 1.0);
}

// The mean over the rays is that of the horizons: what the bias took off it is given back once.
vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    vec2 sum = gloam_ray_gather(position, normal, camera, kernel, method);
    float occlusion = 1.0 - gloam_hbao_visibility(gloam_weighted_ratio(sum), method.angle_bias, method.intensity);
    return vec2(sum.y * occlusion, sum.y);
}

#endif
