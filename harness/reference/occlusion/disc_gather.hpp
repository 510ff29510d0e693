// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/fox_compton.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/sampling/disc.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/rotation.hpp"

namespace gloam::reference {

template <class T, class Fetch>
T gloam_disc_contribution(vec3<T> position, vec3<T> normal, glm::ivec2 at, GloamCamera<T> camera,
                          GloamKernel<T> kernel, T epsilon, Fetch&& fetch_depth) {
    const T depth = fetch_depth(at);
    if (gloam_is_background(depth)) return T(0);
    const vec3<T> surface = gloam_camera_position(at, depth, camera);
    const vec3<T> offset = surface - position;
    const T reach = dot(offset, gloam_safe_normalize(offset, vec3<T>(T(0), T(0), T(0))));
    const bool inside = reach <= kernel.radius;
    const bool above = dot(offset, normal) > kernel.bias;
    if (!(inside && above)) return T(0);
    return gloam_contribution_fox_compton_scaled(position, normal, surface, epsilon);
}

template <class T, class Fetch>
vec2<T> gloam_disc_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera, GloamKernel<T> kernel,
                          T epsilon, Fetch&& fetch_depth) {
    vec2<T> accumulated(T(0), T(0));
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    const vec3<T> n = gloam_safe_normalize(normal, vec3<T>(T(0), T(0), T(0)));
    const vec2<T> center = gloam_camera_uv(position, camera);
    const vec2<T> reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    for (unsigned i = 0; i < kernel.count; ++i) {
        const vec2<T> zeta = gloam_halton_2d<T>(kernel.first + i + 1U);
        const vec2<T> point = gloam_rotate_disc(gloam_disc_sample(zeta), kernel.angle);
        const glm::ivec2 at = gloam_nearest_pixel(center + reach * point, camera.size);
        accumulated = gloam_estimator_add(
            accumulated, gloam_disc_contribution(position, n, at, camera, kernel, epsilon, fetch_depth));
    }
    return accumulated;
}

}  // namespace gloam::reference
