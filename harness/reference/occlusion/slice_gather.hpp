// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/camera.hpp"
#include "reference/geometry/into_slice.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/safe_normalize.hpp"
#include "reference/geometry/slice.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/method_parameters.hpp"
#include "reference/sampling/circle.hpp"
#include "reference/sampling/radical_inverse.hpp"

// What GLSL asks for by prototypes is here an argument: a Method has view(eye), start(slice, normal, share,
// method), step(march, slice, offset, positive, kernel, method) and end(accumulated, march, slice, method).
namespace gloam::reference {

struct GloamMarch {
    dvec2 positive;
    dvec2 negative;
    double share;
    unsigned sectors;
};

struct GloamSlicePoint {
    dvec3 position;
    dvec3 normal;
    dvec2 direction;
    double jitter;
};

template <class Method>
GloamMarch gloam_slice_march(GloamMarch march, GloamSlice slice, GloamSlicePoint point, GloamCamera camera,
                             GloamKernel kernel, GloamMethod parameters, Method method,
                             const Fetch<double>& fetch_depth) {
    const dvec2 center = gloam_camera_uv(point.position, camera);
    const glm::ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    const dvec2 reach = gloam_camera_radius(kernel.radius, -point.position.z, camera) * point.direction;
    const dvec3 axis = cross(slice.tangent, slice.view);
    for (unsigned i = 0; i < 2U * parameters.steps; ++i) {
        const bool positive = (i & 1U) == 0U;
        const double share = (double(i / 2U) + point.jitter) / double(parameters.steps);
        const double side = positive ? double(share * share) : double(-share * share);
        const glm::ivec2 at = gloam_nearest_pixel(center + side * reach, camera.size);
        const double depth = fetch_depth(at);
        if (at == pixel || gloam_is_background(depth)) continue;
        const dvec3 seen = gloam_camera_position(at, depth, camera) - point.position;
        if (!(dot(seen, point.normal) > kernel.bias)) continue;
        const dvec3 offset = gloam_into_slice(seen, axis, point.normal);
        march = method.step(march, slice, offset, positive, kernel, parameters);
    }
    return march;
}

inline unsigned gloam_slice_samples(unsigned count, unsigned steps) {
    const unsigned taps = 2U * std::max(steps, 1U);
    return count < taps ? taps : count - count % taps;
}

template <class Method>
dvec2 gloam_slice_gather(dvec3 position, dvec3 normal, GloamCamera camera, GloamKernel kernel,
                         GloamMethod parameters, Method method, const Fetch<double>& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return dvec2(0.0);
    const dvec3 n = gloam_safe_normalize(normal, dvec3(0.0));
    const dvec3 ahead(0.0, 0.0, 1.0);
    const dvec3 eye = camera.orthographic ? ahead : gloam_safe_normalize(-position, ahead);
    const dvec3 view = method.view(eye);
    const dvec2 upright(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
    const unsigned taps = 2U * std::max(parameters.steps, 1U);
    const double turned = abs(kernel.angle) <= 65536.0 ? kernel.angle / double(6.283185307F) : 0.0;
    dvec2 accumulated(0.0, 0.0);
    for (unsigned i = 0; i < std::max(kernel.count / taps, 1U); ++i) {
        const unsigned index = kernel.first / taps + i + 1U;
        const double turn = 0.5 * fract(gloam_radical_inverse_base2(index) + turned);
        const dvec2 direction = gloam_circle_point(turn);
        const double jitter = fract(gloam_radical_inverse(index, 3U) + turned);
        const GloamSlice slice = gloam_slice(direction * upright, view, n);
        GloamMarch march = method.start(slice, n, gloam_radical_inverse(index, 5U), parameters);
        const GloamSlicePoint point{position, n, direction, jitter};
        march = gloam_slice_march(march, slice, point, camera, kernel, parameters, method, fetch_depth);
        accumulated = method.end(accumulated, march, slice, parameters);
    }
    return gloam_estimator_of_weighted(accumulated, gloam_slice_samples(kernel.count, parameters.steps));
}

}  // namespace gloam::reference
