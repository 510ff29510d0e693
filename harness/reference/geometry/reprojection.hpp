// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
bool gloam_uv_from_clip(vec4<T> clip, vec2<T>& uv) {
    uv = vec2<T>(T(0), T(0));
    if (!(clip.w >= T(1e-30) && clip.w <= T(0x1p126))) return false;
    if (!(abs(clip.x) <= clip.w && abs(clip.y) <= clip.w)) return false;
    const vec2<T> centered(clip.x, clip.y);
    uv = min((T(0.5) * centered + T(0.5) * clip.w) / clip.w, vec2<T>(T(1), T(1)));
    return true;
}

template <class T>
bool gloam_reproject_clip(vec4<T> clip_position, mat4<T> previous_from_current, vec2<T>& uv) {
    return gloam_uv_from_clip(multiply(previous_from_current, clip_position), uv);
}

namespace detail {

template <class T>
vec4<T> finite_or_zero(vec4<T> v) {
    if (gloam_is_finite4(v)) return v;
    return vec4<T>(T(0), T(0), T(0), T(0));
}

}  // namespace detail

template <class T>
vec4<T> gloam_previous_clip_static(vec4<T> clip, mat4<T> inverse_projection, mat4<T> inverse_view,
                                   mat4<T> previous_view, mat4<T> previous_projection) {
    const vec4<T> world = multiply(inverse_view, multiply(inverse_projection, clip));
    return detail::finite_or_zero<T>(multiply(previous_projection, multiply(previous_view, world)));
}

template <class T>
vec4<T> gloam_previous_clip_moving(vec4<T> clip, mat4<T> inverse_projection, mat4<T> inverse_view,
                                   mat4<T> inverse_model, mat4<T> previous_model, mat4<T> previous_view,
                                   mat4<T> previous_projection) {
    const vec4<T> object =
        multiply(inverse_model, multiply(inverse_view, multiply(inverse_projection, clip)));
    const vec4<T> view = multiply(previous_view, multiply(previous_model, object));
    return detail::finite_or_zero<T>(multiply(previous_projection, view));
}

template <class T>
vec3<T> gloam_previous_world(vec3<T> world, mat4<T> inverse_model, mat4<T> previous_model) {
    const vec4<T> object = multiply(inverse_model, vec4<T>(world.x, world.y, world.z, T(1)));
    const vec4<T> moved = multiply(previous_model, object);
    const vec3<T> previous(moved.x, moved.y, moved.z);
    if (gloam_is_finite3(previous)) return previous;
    return vec3<T>(T(0), T(0), T(0));
}

template <class T>
T gloam_previous_depth(vec3<T> previous_world, mat4<T> previous_view) {
    const vec4<T> world(previous_world.x, previous_world.y, previous_world.z, T(1));
    const T depth = -multiply(previous_view, world).z;
    return gloam_is_finite(depth) ? depth : T(0);
}

}  // namespace gloam::reference
