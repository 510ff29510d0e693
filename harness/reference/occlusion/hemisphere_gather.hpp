// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/camera.hpp"
#include "reference/geometry/pixel_center.hpp"
#include "reference/geometry/plane_depth.hpp"
#include "reference/occlusion/blocked.hpp"
#include "reference/occlusion/estimator.hpp"
#include "reference/occlusion/gather_kernel.hpp"
#include "reference/sampling/halton.hpp"
#include "reference/sampling/hemisphere.hpp"
#include "reference/sampling/rotation.hpp"
#include "reference/sampling/tangent_frame.hpp"

namespace gloam::reference {

template <class T, class Fetch>
vec2<T> gloam_hemisphere_tap(vec2<T> accumulated, vec3<T> position, mat3<T> frame, GloamCamera<T> camera,
                             GloamKernel<T> kernel, T range, unsigned index, Fetch&& fetch_depth) {
    const unsigned number = index % 16777216U;  // the sequence starts over there, at its point at the centre
    if (number == 0U) return accumulated;
    const vec3<T> point =
        gloam_rotate_hemisphere(gloam_hemisphere_cosine(gloam_halton_3d<T>(number)), kernel.angle);
    const vec3<T> at = position + (frame * point) * kernel.radius;
    const T depth = -at.z;
    if (gloam_is_background(depth) || !gloam_is_finite(at.x) || !gloam_is_finite(at.y)) return accumulated;
    const glm::ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
    const T surface = fetch_depth(pixel);
    const T at_center = gloam_plane_depth(pixel, at, vec3<T>(frame[2]), camera);
    return gloam_estimator_add(accumulated, gloam_sample_blocked(at_center, surface, kernel.bias, range));
}

template <class T, class Fetch>
vec2<T> gloam_hemisphere_gather(vec3<T> position, vec3<T> normal, GloamCamera<T> camera,
                                GloamKernel<T> kernel, T range, Fetch&& fetch_depth) {
    vec2<T> accumulated(T(0), T(0));
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    const mat3<T> frame = gloam_tangent_frame(normal);
    for (unsigned taken = 0; taken < kernel.count; ++taken) {
        const unsigned index = kernel.first + taken + 1U;
        accumulated =
            gloam_hemisphere_tap(accumulated, position, frame, camera, kernel, range, index, fetch_depth);
    }
    return accumulated;
}

}  // namespace gloam::reference
