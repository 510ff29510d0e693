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

template <class Method>
double gloam_tap_at(dvec3 position, dvec3 normal, glm::ivec2 at, GloamCamera camera, GloamKernel kernel,
                    GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    const double depth = fetch_depth(at);
    if (gloam_is_background(depth)) return 0.0;
    const dvec3 offset = gloam_camera_position(at, depth, camera) - position;
    return method.occlusion(offset, normal, -position.z, kernel, parameters);
}

template <class Method>
dvec2 gloam_tap_gather(dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                       GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    dvec2 accumulated(0.0, 0.0);
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return accumulated;
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 center = gloam_camera_uv(position, camera);
    const glm::ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    const dvec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    for (unsigned i = 0; i < kernel.count; ++i) {
        const dvec2 tap = method.tap(i, position, kernel);
        const glm::ivec2 aimed = gloam_nearest_pixel(center + reach * tap, camera.size);
        const glm::ivec2 at = gloam_tap_pixel(aimed, pixel, camera.size, parameters.mip_distance);
        accumulated = gloam_estimator_add(
            accumulated, gloam_tap_at(position, n, at, camera, kernel, parameters, method, fetch_depth));
    }
    return accumulated;
}

}  // namespace gloam::reference
