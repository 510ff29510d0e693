// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_RAY_GATHER_GLSL
#define GLOAM_OCCLUSION_RAY_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/plane_depth.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/further_layers.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/eye_march.glsl"
#include "gloam/sampling/tangent_frame.glsl"

// Methods that march rays of the view space and look at what the eye sees where each step is projected (CS-C2, CS-J): the loop over
// rays and steps. A method says where a ray goes, what a step tells and what comes out.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// A ray from the shaded point.
struct GloamRay {
    vec3 direction;  // unit, view space
    float jitter;    // part of a step by which the first lies before its place, [0, 1]: see gloam_eye_march
    vec2 seen;       // what the method has seen along it so far; x from 1 on: no further step changes it
};

// A step of a ray, as a method sees it.
struct GloamRayTap {
    vec3 offset;         // from the shaded point to the surface at the step's pixel, view space, world units
    float depth;         // of the step's point, moved to the centre of its pixel along the plane parallel to the surface, so that a bare
                         // plane is the same at any tilt; eye-linear, world units
    float buffer_depth;  // of the surface; likewise
};

// Defined by the method: a ray before its first step.
// index: number of the ray, from 0. frame: columns tangent, bitangent, normal, view space.
GloamRay gloam_method_ray(uint index, mat3 frame, GloamKernel kernel, GloamMethod method);

// Defined by the method: GloamRay.seen after a step. normal: of the shaded point, unit.
vec2 gloam_method_ray_step(GloamRay ray, GloamRayTap tap, vec3 normal, GloamKernel kernel, GloamMethod method);

// Defined by the method: (occlusion times weight, weight) of a ray that has been marched. normal: of the shaded point, unit.
vec2 gloam_method_ray_end(GloamRay ray, vec3 normal, GloamMethod method);

// All steps of a ray, evenly spaced up to the radius.
// position: of the shaded point, view space, world units. normal: of it, unit.
// Returns the ray with what the method has seen; outside the image the nearest pixel counts. Background, the point's own pixel and steps
// that are not in front of the eye do not. Further layers are further steps at the same place. Error: that of the method's steps, but for points within rounding of a pixel's border.
GloamRay gloam_ray_march(GloamRay ray, vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(position, camera), camera.size);
    int steps = int(method.steps);
    for (int i = 0; i < steps && !(ray.seen.x >= 1.0); ++i) {
        vec3 at = gloam_eye_march(position, ray.direction, kernel.radius, i, steps, ray.jitter);
        if (gloam_is_background(-at.z) || !gloam_is_finite2(at.xy)) continue;
        ivec2 there = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
        for (int layer = 0; layer < GLOAM_LAYERS; ++layer) {
            float depth = layer == 0 ? gloam_fetch_depth(there) : abs(GLOAM_FURTHER_LAYER(there, layer));
            if (there == pixel || gloam_is_background(depth)) break;
            vec3 offset = gloam_camera_position(there, depth, camera) - position;
            GloamRayTap tap = GloamRayTap(offset, gloam_plane_depth(there, at, normal, camera), depth);
            ray.seen = gloam_method_ray_step(ray, tap, normal, kernel, method);
        }
    }
    return ray;
}

// Samples that are taken where `count` are asked for: those of whole rays, of `steps` taps each, at least one. What follows in the sequence
// begins that many samples later.
// count: k. steps: GloamMethod::steps.
// Returns a multiple of max(steps, 1). Error: none.
uint gloam_ray_samples(uint count, uint steps) {
    uint taps = max(steps, 1u);
    return max(count / taps, 1u) * taps;
}

// All samples of one pixel in one frame: as many rays of `steps` taps as kernel.count allows, at least one.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, samples taken), see gloam_ray_samples, for gloam_estimator_mean, the mean being that of the rays, weighted. (0, 0) where there is nothing to
// gather: background, no normal, no radius. Error: that of the rays, but for taps within rounding of a pixel's border.
vec2 gloam_ray_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (!gloam_can_gather(position, normal, kernel.radius)) return vec2(0.0);
    mat3 frame = gloam_tangent_frame(normal);
    uint taps = max(method.steps, 1u);
    vec2 weighted = vec2(0.0);
    uint taken = gloam_ray_samples(kernel.count, method.steps);
    for (uint i = 0u; i < taken / taps; ++i) {
        GloamRay ray = gloam_method_ray(kernel.first / taps + i, frame, kernel, method);
        ray = gloam_ray_march(ray, position, frame[2], camera, kernel, method);
        weighted += gloam_method_ray_end(ray, frame[2], method);
    }
    return gloam_estimator_of_weighted(weighted, taken);
}

#endif
