// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/length.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/method_parameters.hpp"
#include "reference/sampling/circle.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/rotation.hpp"

// What GLSL asks for by a prototype is here an argument: a Method has occlusion(proxy, normal, camera,
// kernel, method).
namespace gloam::reference {

template <class T>
struct GloamProxy {
    vec3<T> offset;
    vec2<T> size;
    glm::ivec2 pixel;
    int layer;
};

template <class T, class Method, class Fetch>
T gloam_proxy_at(vec3<T> position, vec3<T> normal, glm::ivec2 at, GloamCamera<T> camera,
                 GloamKernel<T> kernel, GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    const T depth = fetch_depth(at);
    if (gloam_is_background(depth)) return T(0);
    const vec3<T> offset = gloam_camera_position(at, depth, camera) - position;
    if (!(dot(offset, normal) > kernel.bias && gloam_length(offset) <= kernel.radius &&
          kernel.radius <= float_max<T>()))
        return T(0);
    const vec2<T> size(T(camera.size.x), T(camera.size.y));
    const vec2<T> pixels = gloam_camera_radius(kernel.radius, depth, camera) * size;
    const GloamProxy<T> proxy{offset, kernel.radius / pixels, at, 0};
    return method.occlusion(proxy, normal, camera, kernel, parameters);
}

template <class T, class Method, class Fetch>
vec2<T> gloam_proxy_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                           GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    vec2<T> accumulated(T(0), T(0));
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return accumulated;
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(0)));
    const vec2<T> center = gloam_camera_uv(position, camera);
    const glm::ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    const vec2<T> reach = gloam_camera_radius(kernel.radius, T(-position.z), camera);
    const vec2<T> axes = reach * vec2<T>(T(camera.size.x), T(camera.size.y));
    const T pixels = T(3.141592654F) * axes.x * axes.y;
    for (unsigned i = 0; i < kernel.count; ++i) {
        const vec2<T> zeta = gloam_halton_2d<T>(kernel.first + i + 1U);
        const vec2<T> tap = gloam_rotate_disc(zeta.y * gloam_circle_point(zeta.x), kernel.angle);
        const glm::ivec2 at = gloam_nearest_pixel(center + reach * tap, camera.size);
        const T piece =
            at == pixel ? T(0)
                        : gloam_proxy_at(position, n, at, camera, kernel, parameters, method, fetch_depth);
        const T share = piece > T(0) ? T(T(2) * zeta.y * pixels * piece) : T(0);
        accumulated = gloam_estimator_add(accumulated, share);
    }
    const T sum = parameters.intensity * accumulated.x;
    const T bounded = sum > T(0) ? min(sum, accumulated.y) : T(0);
    return vec2<T>(bounded, accumulated.y);
}

}  // namespace gloam::reference
