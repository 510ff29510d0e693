// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/camera.hpp"
#include "reference/geometry/finite.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/method_parameters.hpp"
#include "reference/sampling/eye_march.hpp"
#include "reference/sampling/tangent_frame.hpp"

// What GLSL asks for by prototypes is here an argument: a Method has ray(index, frame, kernel, method),
// step(ray, tap, normal, kernel, method) and end(ray, normal, method).
namespace gloam::reference {

template <class T>
struct GloamRay {
    vec3<T> direction;
    T jitter;
    vec2<T> seen;
};

template <class T>
struct GloamRayTap {
    vec3<T> offset;
    T depth;
    T buffer_depth;
};

template <class T, class Method, class Fetch>
GloamRay<T> gloam_ray_march(GloamRay<T> ray, vec3<T> position, vec3<T> normal, GloamCamera<T> camera,
                            GloamKernel<T> kernel, GloamMethod<T> parameters, Method method,
                            Fetch&& fetch_depth) {
    const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(position, camera), camera.size);
    const int steps = static_cast<int>(parameters.steps);
    for (int i = 0; i < steps && !(ray.seen.x >= T(1)); ++i) {
        const vec3<T> at = gloam_eye_march(position, ray.direction, kernel.radius, i, steps, ray.jitter);
        if (gloam_is_background(T(-at.z)) || !gloam_is_finite2(vec2<T>(at.x, at.y))) continue;
        const glm::ivec2 there = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
        const T depth = fetch_depth(there);
        if (there == pixel || gloam_is_background(depth)) continue;
        const vec3<T> offset = gloam_camera_position(there, depth, camera) - position;
        const GloamRayTap<T> tap{offset, gloam_plane_depth(there, at, normal, camera), depth};
        ray.seen = method.step(ray, tap, normal, kernel, parameters);
    }
    return ray;
}

template <class T>
unsigned gloam_ray_samples(unsigned count, unsigned steps) {
    const unsigned taps = std::max(steps, 1U);
    return count < taps ? taps : count - count % taps;
}

template <class T, class Method, class Fetch>
vec2<T> gloam_ray_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                         GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return vec2<T>(T(0), T(0));
    const mat3<T> frame = gloam_tangent_frame(normal);
    const unsigned taps = std::max(parameters.steps, 1U);
    vec2<T> weighted(T(0), T(0));
    for (unsigned i = 0; i < std::max(kernel.count / taps, 1U); ++i) {
        GloamRay<T> ray = method.ray(kernel.first / taps + i, frame, kernel, parameters);
        ray = gloam_ray_march(ray, position, vec3<T>(frame[2]), camera, kernel, parameters, method,
                              fetch_depth);
        weighted += method.end(ray, vec3<T>(frame[2]), parameters);
    }
    return gloam_estimator_of_weighted(weighted, gloam_ray_samples<T>(kernel.count, parameters.steps));
}

}  // namespace gloam::reference
