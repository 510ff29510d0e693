// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/height_at.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/method_parameters.hpp"
#include "reference/sampling/halton_disc.hpp"

// What GLSL asks for by prototypes is here an argument: a Method has occlusion(pair, kernel, method).
namespace gloam::reference {

template <class T>
struct GloamPair {
    vec2<T> point;
    vec2<T> heights;
    vec3<T> first;
    vec3<T> second;
    vec3<T> view;
    vec3<T> normal;
};

template <class T, class Fetch>
vec3<T> gloam_pair_offset(vec3<T> position, glm::ivec2 at, GloamCamera<T> camera, T radius,
                          Fetch&& fetch_depth) {
    const T depth = fetch_depth(at);
    const T farthest = -position.z + T(1e4) * radius;
    const vec3<T> offset =
        gloam_camera_position(at, gloam_is_background(depth) ? farthest : depth, camera) - position;
    return gloam_is_finite3(offset) ? offset : vec3<T>(T(0), T(0), T(0));
}

template <class T>
unsigned gloam_paired_samples(unsigned count) {
    return 2U * (count / 2U + count % 2U);
}

template <class T, class Method, class Fetch>
vec2<T> gloam_pair_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                          GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return vec2<T>(T(0), T(0));
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(0)));
    const vec2<T> center = gloam_camera_uv(position, camera);
    const vec2<T> reach = gloam_camera_radius(kernel.radius, T(-position.z), camera);
    const vec3<T> ahead(T(0), T(0), T(1));
    const vec3<T> view = camera.orthographic ? ahead : gloam_safe_normalize(-position, ahead);
    const vec2<T> upright(T(1), camera.p00_p11.y < T(0) ? T(-1) : T(1));
    vec2<T> weighted(T(0), T(0));
    for (unsigned i = 0; i < kernel.count; i += 2U) {
        const vec2<T> point = gloam_halton_disc((kernel.first + i) / 2U + 1U, gloam_sincos(kernel.angle));
        const glm::ivec2 first = gloam_nearest_pixel(center + reach * point, camera.size);
        const glm::ivec2 second = gloam_nearest_pixel(center - reach * point, camera.size);
        const vec2<T> in_plane = kernel.radius * point * upright;
        const vec3<T> aim(in_plane.x, in_plane.y, T(0));
        const vec3<T> one = gloam_pair_offset(position, first, camera, kernel.radius, fetch_depth);
        const vec3<T> other = gloam_pair_offset(position, second, camera, kernel.radius, fetch_depth);
        const vec2<T> heights(gloam_height_at(one, aim, view, n), gloam_height_at(other, -aim, view, n));
        const GloamPair<T> pair{point * upright,        heights, aim + heights.x * view,
                                heights.y * view - aim, view,    n};
        weighted += method.occlusion(pair, kernel, parameters);
    }
    return gloam_estimator_of_weighted(weighted, gloam_paired_samples<T>(kernel.count));
}

}  // namespace gloam::reference
