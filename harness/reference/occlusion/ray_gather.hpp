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

struct GloamRay {
    dvec3 direction;
    double jitter;
    dvec2 seen;
};

struct GloamRayTap {
    dvec3 offset;
    double depth;
    double buffer_depth;
};

template <class Method>
GloamRay gloam_ray_march(GloamRay ray, dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                         GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(position, camera), camera.size);
    const int steps = static_cast<int>(parameters.steps);
    for (int i = 0; i < steps && !(ray.seen.x >= 1.0); ++i) {
        const dvec3 at = gloam_eye_march(position, ray.direction, kernel.radius, i, steps, ray.jitter);
        if (gloam_is_background(-at.z) || !gloam_is_finite2(dvec2(at.x, at.y))) continue;
        const glm::ivec2 there = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
        const double depth = fetch_depth(there);
        if (there == pixel || gloam_is_background(depth)) continue;
        const dvec3 offset = gloam_camera_position(there, depth, camera) - position;
        const GloamRayTap tap{offset, gloam_plane_depth(there, at, normal, camera), depth};
        ray.seen = method.step(ray, tap, normal, kernel, parameters);
    }
    return ray;
}

inline unsigned gloam_ray_samples(unsigned count, unsigned steps) {
    const unsigned taps = std::max(steps, 1U);
    return count < taps ? taps : count - count % taps;
}

template <class Method>
dvec2 gloam_ray_gather(dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                       GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return dvec2(0.0);
    const dmat3 frame = gloam_tangent_frame(normal);
    const unsigned taps = std::max(parameters.steps, 1U);
    dvec2 weighted(0.0, 0.0);
    for (unsigned i = 0; i < std::max(kernel.count / taps, 1U); ++i) {
        GloamRay ray = method.ray(kernel.first / taps + i, frame, kernel, parameters);
        ray =
            gloam_ray_march(ray, position, dvec3(frame[2]), camera, kernel, parameters, method, fetch_depth);
        weighted += method.end(ray, dvec3(frame[2]), parameters);
    }
    return gloam_estimator_of_weighted(weighted, gloam_ray_samples(kernel.count, parameters.steps));
}

}  // namespace gloam::reference
