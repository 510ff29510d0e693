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

struct GloamPair {
    dvec2 point;
    dvec2 heights;
    dvec3 first;
    dvec3 second;
    dvec3 view;
    dvec3 normal;
};

inline dvec3 gloam_pair_offset(dvec3 position, glm::ivec2 at, GloamCamera camera, double radius,
                               const Fetch<double>& fetch_depth) {
    const double depth = fetch_depth(at);
    const double farthest = -position.z + 1e4 * radius;
    const dvec3 offset =
        gloam_camera_position(at, gloam_is_background(depth) ? farthest : depth, camera) - position;
    return gloam_is_finite3(offset) ? offset : dvec3(0.0);
}

inline unsigned gloam_paired_samples(unsigned count) {
    return 2U * (count / 2U + count % 2U);
}

template <class Method>
dvec2 gloam_pair_gather(dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                        GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return dvec2(0.0);
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec2 center = gloam_camera_uv(position, camera);
    const dvec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    const dvec3 ahead(0.0, 0.0, 1.0);
    const dvec3 view = camera.orthographic ? ahead : gloam_safe_normalize(-position, ahead);
    const dvec2 upright(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
    dvec2 weighted(0.0, 0.0);
    for (unsigned i = 0; i < kernel.count; i += 2U) {
        const dvec2 point = gloam_halton_disc((kernel.first + i) / 2U + 1U, gloam_sincos(kernel.angle));
        const glm::ivec2 first = gloam_nearest_pixel(center + reach * point, camera.size);
        const glm::ivec2 second = gloam_nearest_pixel(center - reach * point, camera.size);
        const dvec2 in_plane = kernel.radius * point * upright;
        const dvec3 aim(in_plane.x, in_plane.y, 0.0);
        const dvec3 one = gloam_pair_offset(position, first, camera, kernel.radius, fetch_depth);
        const dvec3 other = gloam_pair_offset(position, second, camera, kernel.radius, fetch_depth);
        const dvec2 heights(gloam_height_at(one, aim, view, n), gloam_height_at(other, -aim, view, n));
        const GloamPair pair{point * upright,        heights, aim + heights.x * view,
                             heights.y * view - aim, view,    n};
        weighted += method.occlusion(pair, kernel, parameters);
    }
    return gloam_estimator_of_weighted(weighted, gloam_paired_samples(kernel.count));
}

}  // namespace gloam::reference
