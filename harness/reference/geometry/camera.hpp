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

inline dvec2 gloam_camera_uv(dvec3 view_position, const GloamCamera& camera) {
    const auto ndc = camera.orthographic ? gloam_ndc_orthographic : gloam_ndc_perspective;
    return gloam_uv_from_ndc(ndc(view_position, camera.p00_p11));
}

inline dvec3 gloam_camera_position(glm::ivec2 pixel, double depth, const GloamCamera& camera) {
    const auto position =
        camera.orthographic ? gloam_view_position_orthographic : gloam_view_position_perspective;
    return position(gloam_ndc_from_pixel(pixel, camera.size), depth, camera.p00_p11);
}

inline dvec2 gloam_camera_radius(double radius, double depth, const GloamCamera& camera) {
    const auto axes =
        camera.orthographic ? gloam_projected_radius_uv_orthographic : gloam_projected_radius_uv;
    return axes(radius, depth, camera.p00_p11);
}

}  // namespace gloam::reference
