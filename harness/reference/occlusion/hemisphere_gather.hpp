// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/occlusion/ritschel.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"
#include "reference/sampling/rotation.hpp"
#include "reference/sampling/tangent_frame.hpp"

namespace gloam::reference {

template <class T, class Fetch>
vec2<T> gloam_hemisphere_tap(vec2<T> accumulated, vec3<T> position, mat3<T> frame, GloamCamera<T> camera,
                             GloamKernel<T> kernel, T range, unsigned index, Fetch&& fetch_depth) {
    const vec3<T> point =
        gloam_rotate_hemisphere(gloam_hemisphere_cosine(gloam_halton_3d<T>(index)), kernel.angle);
    const vec3<T> at = position + kernel.radius * multiply(frame, point);
    const bool none = point.x == T(0) && point.y == T(0) && point.z == T(0);
    if (none || gloam_is_background(T(-at.z)) || !gloam_is_finite2(vec2<T>(at.x, at.y))) return accumulated;
    const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
    const T depth = gloam_plane_depth(pixel, at, vec3<T>(frame[2]), camera);
    const T blocked = gloam_sample_blocked(depth, T(fetch_depth(pixel)), kernel.bias, range);
    return gloam_estimator_add(accumulated, gloam_contribution_cosine_directions(blocked, T(1)));
}

template <class T, class Fetch>
vec2<T> gloam_hemisphere_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera,
                                GloamKernel<T> kernel, T range, Fetch&& fetch_depth) {
    vec2<T> accumulated(T(0), T(0));
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    const mat3<T> frame = gloam_tangent_frame(normal);
    for (unsigned i = 0; i < kernel.count; ++i) {
        const unsigned index = kernel.first + i + 1U;
        accumulated =
            gloam_hemisphere_tap(accumulated, position, frame, camera, kernel, range, index, fetch_depth);
    }
    return accumulated;
}

}  // namespace gloam::reference
