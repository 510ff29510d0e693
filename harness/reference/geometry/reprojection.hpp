// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
bool gloam_uv_from_clip(vec4<T> clip, vec2<T>& uv) {
    uv = vec2<T>(T(0), T(0));
    if (!(clip.w >= float_min<T>() && clip.w <= T(8.5070591730234616e37))) return false;
    const T u = clip.x / clip.w / T(2) + T(0.5);
    const T v = clip.y / clip.w / T(2) + T(0.5);
    if (!(abs(clip.x) <= clip.w)) return false;
    if (!(abs(clip.y) <= clip.w)) return false;
    uv = vec2<T>(u, v);
    return true;
}

template <class T>
bool gloam_reproject_clip(vec4<T> clip_position, mat4<T> previous_from_current, vec2<T>& uv) {
    return gloam_uv_from_clip(vec4<T>(previous_from_current * clip_position), uv);
}

namespace detail {

template <class T>
vec4<T> finite_or_zero(vec4<T> v) {
    if (gloam_is_finite4(v)) return v;
    return vec4<T>(T(0), T(0), T(0), T(0));
}

}  // namespace detail

// The matrices of the chain are multiplied first here, the point comes last.
template <class T>
vec4<T> gloam_previous_clip_static(vec4<T> clip, mat4<T> inverse_projection, mat4<T> inverse_view,
                                   mat4<T> previous_view, mat4<T> previous_projection) {
    const mat4<T> world_from_clip = inverse_view * inverse_projection;
    return detail::finite_or_zero<T>(previous_projection * previous_view * world_from_clip * clip);
}

template <class T>
vec4<T> gloam_previous_clip_moving(vec4<T> clip, mat4<T> inverse_projection, mat4<T> inverse_view,
                                   mat4<T> inverse_model, mat4<T> previous_model, mat4<T> previous_view,
                                   mat4<T> previous_projection) {
    const mat4<T> object_from_clip = inverse_model * inverse_view * inverse_projection;
    const mat4<T> previous_from_object = previous_projection * previous_view * previous_model;
    return detail::finite_or_zero<T>(previous_from_object * object_from_clip * clip);
}

template <class T>
vec3<T> gloam_previous_world(vec3<T> world, mat4<T> inverse_model, mat4<T> previous_model) {
    const vec4<T> moved = previous_model * inverse_model * vec4<T>(world.x, world.y, world.z, T(1));
    const vec3<T> previous(moved.x, moved.y, moved.z);
    if (gloam_is_finite3(previous)) return previous;
    return vec3<T>(T(0), T(0), T(0));
}

template <class T>
T gloam_previous_depth(vec3<T> previous_world, mat4<T> previous_view) {
    const vec4<T> view = previous_view * vec4<T>(previous_world.x, previous_world.y, previous_world.z, T(1));
    if (gloam_is_finite(view.z)) return -view.z;
    return T(0);
}

}  // namespace gloam::reference
