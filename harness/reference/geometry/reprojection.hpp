// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline bool gloam_uv_from_clip(dvec4 clip, dvec2& uv) {
    uv = dvec2(0.0);
    const double w = clip.w;
    if (!(w >= 1e-30 && w <= 0x1p126 && abs(clip.x) <= w && abs(clip.y) <= w)) return false;
    uv = dvec2(clip) / (2.0 * w) + 0.5;
    return true;
}

inline bool gloam_reproject_clip(dvec4 clip_position, dmat4 previous_from_current, dvec2& uv) {
    return gloam_uv_from_clip(previous_from_current * clip_position, uv);
}

inline dvec4 gloam_previous_clip_static(dvec4 clip, dmat4 inverse_projection, dmat4 inverse_view,
                                        dmat4 previous_view, dmat4 previous_projection) {
    const dvec4 previous = previous_projection * previous_view * inverse_view * inverse_projection * clip;
    return is_finite(previous) ? previous : dvec4(0.0);
}

inline dvec4 gloam_previous_clip_moving(dvec4 clip, dmat4 inverse_projection, dmat4 inverse_view,
                                        dmat4 inverse_model, dmat4 previous_model, dmat4 previous_view,
                                        dmat4 previous_projection) {
    const dmat4 world = previous_model * inverse_model * inverse_view;
    return gloam_previous_clip_static(clip, inverse_projection, world, previous_view, previous_projection);
}

inline dvec3 gloam_previous_world(dvec3 world, dmat4 inverse_model, dmat4 previous_model) {
    const dvec3 previous = previous_model * inverse_model * dvec4(world, 1.0);
    return is_finite(previous) ? previous : dvec3(0.0);
}

inline double gloam_previous_depth(dvec3 previous_world, dmat4 previous_view) {
    const double depth = -(previous_view * dvec4(previous_world, 1.0)).z;
    return is_finite(depth) ? depth : 0.0;
}

}  // namespace gloam::reference
