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
// It may have below(...), as step, for taps that are not above the tangent plane.
namespace gloam::reference {

template <class T>
struct GloamMarch {
    vec2<T> positive;
    vec2<T> negative;
    T share;
    unsigned sectors;
};

template <class T>
struct GloamSlicePoint {
    vec3<T> position;
    vec3<T> normal;
    vec2<T> direction;
    T jitter;
};

template <class T, class Method, class Fetch>
GloamMarch<T> gloam_slice_march(GloamMarch<T> march, GloamSlice<T> slice, GloamSlicePoint<T> point,
                                GloamCamera<T> camera, GloamKernel<T> kernel, GloamMethod<T> parameters,
                                Method method, Fetch&& fetch_depth) {
    const vec2<T> center = gloam_camera_uv(point.position, camera);
    const glm::ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    const vec2<T> reach = gloam_camera_radius(kernel.radius, T(-point.position.z), camera) * point.direction;
    const vec3<T> axis = cross(slice.tangent, slice.view);
    for (unsigned i = 0; i < 2U * parameters.steps; ++i) {
        const bool positive = (i & 1U) == 0U;
        const T share = (T(i / 2U) + point.jitter) / T(parameters.steps);
        const T side = positive ? T(share * share) : T(-share * share);
        const glm::ivec2 at = gloam_nearest_pixel(center + side * reach, camera.size);
        const T depth = fetch_depth(at);
        if (at == pixel || gloam_is_background(depth)) continue;
        const vec3<T> seen = gloam_camera_position(at, depth, camera) - point.position;
        const vec3<T> offset = gloam_into_slice(seen, axis, point.normal);
        if (!(dot(seen, point.normal) > kernel.bias)) {
            if constexpr (requires { method.below(march, slice, offset, positive, kernel, parameters); })
                march = method.below(march, slice, offset, positive, kernel, parameters);
            continue;
        }
        march = method.step(march, slice, offset, positive, kernel, parameters);
    }
    return march;
}

template <class T>
unsigned gloam_slice_samples(unsigned count, unsigned steps) {
    const unsigned taps = 2U * std::max(steps, 1U);
    return count < taps ? taps : count - count % taps;
}

template <class T, class Method, class Fetch>
vec2<T> gloam_slice_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                           GloamMethod<T> parameters, Method method, Fetch&& fetch_depth) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return vec2<T>(T(0), T(0));
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(0)));
    const vec3<T> ahead(T(0), T(0), T(1));
    const vec3<T> eye = camera.orthographic ? ahead : gloam_safe_normalize(-position, ahead);
    const vec3<T> view = method.view(eye);
    const vec2<T> upright(T(1), camera.p00_p11.y < T(0) ? T(-1) : T(1));
    const unsigned taps = 2U * std::max(parameters.steps, 1U);
    const T turned = abs(kernel.angle) <= T(65536) ? kernel.angle / T(6.283185307F) : T(0);
    vec2<T> accumulated(T(0), T(0));
    for (unsigned i = 0; i < std::max(kernel.count / taps, 1U); ++i) {
        const unsigned index = kernel.first / taps + i + 1U;
        const T turn = T(0.5) * fract(gloam_radical_inverse_base2<T>(index) + turned);
        const vec2<T> direction = gloam_circle_point(turn);
        const T jitter = fract(gloam_radical_inverse<T>(index, 3U) + turned);
        const GloamSlice<T> slice = gloam_slice(direction * upright, view, n);
        GloamMarch<T> march = method.start(slice, n, gloam_radical_inverse<T>(index, 5U), parameters);
        const GloamSlicePoint<T> point{position, n, direction, jitter};
        march = gloam_slice_march(march, slice, point, camera, kernel, parameters, method, fetch_depth);
        accumulated = method.end(accumulated, march, slice, parameters);
    }
    return gloam_estimator_of_weighted(accumulated, gloam_slice_samples<T>(kernel.count, parameters.steps));
}

}  // namespace gloam::reference
