// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/method_parameters.hpp"
#include "reference/sampling/tangent_frame.hpp"

// What GLSL asks for by prototypes is here an argument: a Method has point(index, angle) and
// occlusion(depth, buffer_depth, kernel, method).
namespace gloam::reference {

template <class T, class Method, class Fetch>
vec2<T> gloam_point_tap(vec2<T> accumulated, vec3<T> position, mat3<T> frame, GloamCamera<T> camera,
                        GloamKernel<T> kernel, GloamMethod<T> parameters, vec3<T> point, Method method,
                        Fetch&& fetch_depth) {
    const vec3<T> at = position + kernel.radius * multiply(frame, point);
    const bool none = point.x == T(0) && point.y == T(0) && point.z == T(0);
    if (none || gloam_is_background(T(-at.z)) || !gloam_is_finite2(vec2<T>(at.x, at.y))) return accumulated;
    const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
    const T depth = gloam_plane_depth(pixel, at, vec3<T>(frame[2]), camera);
    return gloam_estimator_add(accumulated,
                               method.occlusion(depth, T(fetch_depth(pixel)), kernel, parameters));
}

template <class T, class Method, class Fetch>
vec2<T> gloam_point_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                           GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    vec2<T> accumulated(T(0), T(0));
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return accumulated;
    const mat3<T> frame = gloam_tangent_frame(normal);
    for (unsigned i = 0; i < kernel.count; ++i) {
        const vec3<T> point = method.point(kernel.first + i + 1U, kernel.angle);
        accumulated = gloam_point_tap(accumulated, position, frame, camera, kernel, parameters, point, method,
                                      fetch_depth);
    }
    return accumulated;
}

}  // namespace gloam::reference
