// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/position.hpp"
#include "reference/geometry/projected_radius.hpp"

namespace gloam::reference {

struct GloamCamera {
    dvec2 p00_p11;
    glm::ivec2 size;
    bool orthographic;
};

inline dvec2 gloam_camera_uv(dvec3 view_position, GloamCamera camera) {
    if (camera.orthographic) {
        return gloam_uv_from_ndc(gloam_ndc_orthographic(view_position, camera.p00_p11));
    }
    return gloam_uv_from_ndc(gloam_ndc_perspective(view_position, camera.p00_p11));
}

inline dvec3 gloam_camera_position(glm::ivec2 pixel, double depth, GloamCamera camera) {
    const dvec2 ndc = gloam_ndc_from_pixel(pixel, camera.size);
    if (camera.orthographic) return gloam_view_position_orthographic(ndc, depth, camera.p00_p11);
    return gloam_view_position_perspective(ndc, depth, camera.p00_p11);
}

inline dvec2 gloam_camera_radius(double radius, double depth, GloamCamera camera) {
    if (camera.orthographic) {
        return gloam_projected_radius_uv_orthographic(radius, depth, camera.p00_p11);
    }
    return gloam_projected_radius_uv(radius, depth, camera.p00_p11);
}

}  // namespace gloam::reference
