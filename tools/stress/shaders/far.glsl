// SPDX-License-Identifier: MIT
#ifndef STRESS_FAR_GLSL
#define STRESS_FAR_GLSL

#include "gloam/geometry/reprojection.glsl"
#include "gloam/temporal/history.glsl"

// All relative to one origin: that of the world, or the eye.
struct StressCameras {
    mat4 inverse_projection;
    mat4 inverse_view;
    mat4 previous_view;
    mat4 previous_projection;
    vec3 eye;
    vec3 previous_eye;
};

// Where a still point was in the previous frame: relative to the eye. stored: its depth there.
// clip: of the previous frame. kept: whether the history is taken for that of the same surface.
vec3 stress_previous(vec3 point, vec4 current_clip, float stored, StressCameras c, out vec4 clip, out bool kept) {
    clip = gloam_previous_clip_static(current_clip, c.inverse_projection, c.inverse_view, c.previous_view,
                                      c.previous_projection);
    kept = gloam_depth_consistent(stored, gloam_previous_depth(point, c.previous_view), 0.01);
    return gloam_camera_centered_previous(point - c.eye, c.eye - c.previous_eye);
}

#endif
