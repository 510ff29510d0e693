// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline bool gloam_uv_from_clip(dvec4 clip, dvec2& uv) {
    uv = dvec2(0.0);
    if (!(clip.w >= 1e-30 && clip.w <= 0x1p126)) return false;
    if (!(abs(clip.x) <= clip.w && abs(clip.y) <= clip.w)) return false;
    const dvec2 centered(clip.x, clip.y);
    uv = min((0.5 * centered + 0.5 * clip.w) / clip.w, dvec2(1.0, 1.0));
    return true;
}

inline bool gloam_reproject_clip(dvec4 clip_position, dmat4 previous_from_current, dvec2& uv) {
    return gloam_uv_from_clip((previous_from_current * clip_position), uv);
}

namespace detail {

inline dvec4 finite_or_zero(dvec4 v) {
    if (gloam_is_finite4(v)) return v;
    return dvec4(0.0);
}

}  // namespace detail

inline dvec4 gloam_previous_clip_static(dvec4 clip, dmat4 inverse_projection, dmat4 inverse_view,
                                        dmat4 previous_view, dmat4 previous_projection) {
    const dvec4 world = (inverse_view * (inverse_projection * clip));
    return detail::finite_or_zero((previous_projection * (previous_view * world)));
}

inline dvec4 gloam_previous_clip_moving(dvec4 clip, dmat4 inverse_projection, dmat4 inverse_view,
                                        dmat4 inverse_model, dmat4 previous_model, dmat4 previous_view,
                                        dmat4 previous_projection) {
    const dvec4 object = (inverse_model * (inverse_view * (inverse_projection * clip)));
    const dvec4 view = (previous_view * (previous_model * object));
    return detail::finite_or_zero((previous_projection * view));
}

inline dvec3 gloam_previous_world(dvec3 world, dmat4 inverse_model, dmat4 previous_model) {
    const dvec4 object = (inverse_model * dvec4(world.x, world.y, world.z, 1.0));
    const dvec4 moved = (previous_model * object);
    const dvec3 previous(moved.x, moved.y, moved.z);
    if (gloam_is_finite3(previous)) return previous;
    return dvec3(0.0);
}

inline double gloam_previous_depth(dvec3 previous_world, dmat4 previous_view) {
    const dvec4 world(previous_world.x, previous_world.y, previous_world.z, 1.0);
    const double depth = -(previous_view * world).z;
    return gloam_is_finite(depth) ? depth : 0.0;
}

}  // namespace gloam::reference
