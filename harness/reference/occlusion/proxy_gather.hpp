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

struct GloamProxy {
    dvec3 offset;
    dvec2 size;
    glm::ivec2 pixel;
    int layer;
};

template <class Method>
double gloam_proxy_at(dvec3 position, dvec3 normal, glm::ivec2 at, GloamCamera camera, GloamKernel kernel,
                      GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    const double depth = fetch_depth(at);
    if (gloam_is_background(depth)) return 0.0;
    const dvec3 offset = gloam_camera_position(at, depth, camera) - position;
    if (!(dot(offset, normal) > kernel.bias && gloam_length(offset) <= kernel.radius &&
          kernel.radius <= float_max))
        return 0.0;
    const dvec2 size(double(camera.size.x), double(camera.size.y));
    const dvec2 pixels = gloam_camera_radius(kernel.radius, depth, camera) * size;
    const GloamProxy proxy{offset, kernel.radius / pixels, at, 0};
    return method.occlusion(proxy, normal, camera, kernel, parameters);
}

template <class Method>
dvec2 gloam_proxy_gather(dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                         GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    dvec2 accumulated(0.0, 0.0);
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return accumulated;
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 center = gloam_camera_uv(position, camera);
    const glm::ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    const dvec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    const dvec2 axes = reach * dvec2(double(camera.size.x), double(camera.size.y));
    const double pixels = double(3.141592654F) * axes.x * axes.y;
    for (unsigned i = 0; i < kernel.count; ++i) {
        const dvec2 zeta = gloam_halton_2d(kernel.first + i + 1U);
        const dvec2 tap = gloam_rotate_disc(zeta.y * gloam_circle_point(zeta.x), kernel.angle);
        const glm::ivec2 at = gloam_nearest_pixel(center + reach * tap, camera.size);
        const double piece =
            at == pixel ? 0.0
                        : gloam_proxy_at(position, n, at, camera, kernel, parameters, method, fetch_depth);
        const double share = piece > 0.0 ? double(2.0 * zeta.y * pixels * piece) : 0.0;
        accumulated = gloam_estimator_add(accumulated, share);
    }
    const double sum = parameters.intensity * accumulated.x;
    const double bounded = sum > 0.0 ? min(sum, accumulated.y) : 0.0;
    return dvec2(bounded, accumulated.y);
}

}  // namespace gloam::reference
