// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/method_parameters.hpp"
#include "reference/sampling/tap_pixel.hpp"

// What GLSL asks for by prototypes is here an argument: a Method has tap(i, position, kernel) and
// occlusion(offset, normal, depth, kernel, method).
namespace gloam::reference {

template <class T, class Method, class Fetch>
T gloam_tap_at(vec3<T> position, vec3<T> normal, glm::ivec2 at, GloamCamera<T> camera, GloamKernel<T> kernel,
               GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    const T depth = fetch_depth(at);
    if (gloam_is_background(depth)) return T(0);
    const vec3<T> offset = gloam_camera_position(at, depth, camera) - position;
    return method.occlusion(offset, normal, T(-position.z), kernel, parameters);
}

template <class T, class Method, class Fetch>
vec2<T> gloam_tap_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                         GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    vec2<T> accumulated(T(0), T(0));
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return accumulated;
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(0)));
    const vec2<T> center = gloam_camera_uv(position, camera);
    const glm::ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    const vec2<T> reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    for (unsigned i = 0; i < kernel.count; ++i) {
        const vec2<T> tap = method.tap(i, position, kernel);
        const glm::ivec2 aimed = gloam_nearest_pixel(center + reach * tap, camera.size);
        const glm::ivec2 at = gloam_tap_pixel(aimed, pixel, camera.size, parameters.mip_distance);
        accumulated = gloam_estimator_add(
            accumulated, gloam_tap_at(position, n, at, camera, kernel, parameters, method, fetch_depth));
    }
    return accumulated;
}

}  // namespace gloam::reference
