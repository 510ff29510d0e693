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

template <class Method>
dvec2 gloam_point_tap(dvec2 accumulated, dvec3 position, dmat3 frame, GloamCamera camera, GloamKernel kernel,
                      GloamMethod parameters, dvec3 point, Method method, const Fetch<double>& fetch_depth) {
    const dvec3 at = position + kernel.radius * (frame * point);
    const bool none = point.x == 0.0 && point.y == 0.0 && point.z == 0.0;
    if (none || gloam_is_background(-at.z) || !gloam_is_finite2(dvec2(at.x, at.y))) return accumulated;
    const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
    const double depth = gloam_plane_depth(pixel, at, dvec3(frame[2]), camera);
    return gloam_estimator_add(accumulated,
                               method.occlusion(depth, double(fetch_depth(pixel)), kernel, parameters));
}

template <class Method>
dvec2 gloam_point_gather(dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                         GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    dvec2 accumulated(0.0, 0.0);
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return accumulated;
    const dmat3 frame = gloam_tangent_frame(normal);
    for (unsigned i = 0; i < kernel.count; ++i) {
        const dvec3 point = method.point(kernel.first + i + 1U, kernel.angle);
        accumulated = gloam_point_tap(accumulated, position, frame, camera, kernel, parameters, point, method,
                                      fetch_depth);
    }
    return accumulated;
}

}  // namespace gloam::reference
