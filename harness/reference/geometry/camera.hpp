// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/position.hpp"
#include "reference/geometry/projected_radius.hpp"

namespace gloam::reference {

template <class T>
struct GloamCamera {
    vec2<T> p00_p11;
    glm::ivec2 size;
    bool orthographic;
};

template <class T>
vec2<T> gloam_camera_uv(vec3<T> view_position, GloamCamera<T> camera) {
    if (camera.orthographic) {
        return gloam_uv_from_ndc(gloam_ndc_orthographic(view_position, camera.p00_p11));
    }
    return gloam_uv_from_ndc(gloam_ndc_perspective(view_position, camera.p00_p11));
}

template <class T>
vec3<T> gloam_camera_position(glm::ivec2 pixel, T depth, GloamCamera<T> camera) {
    const vec2<T> ndc = gloam_ndc_from_pixel<T>(pixel, camera.size);
    if (camera.orthographic) return gloam_view_position_orthographic(ndc, depth, camera.p00_p11);
    return gloam_view_position_perspective(ndc, depth, camera.p00_p11);
}

template <class T>
vec2<T> gloam_camera_radius(T radius, T depth, GloamCamera<T> camera) {
    if (camera.orthographic) {
        return gloam_projected_radius_uv_orthographic(radius, depth, camera.p00_p11);
    }
    return gloam_projected_radius_uv(radius, depth, camera.p00_p11);
}

}  // namespace gloam::reference
