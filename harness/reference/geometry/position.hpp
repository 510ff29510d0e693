// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"
#include "reference/geometry/finite.hpp"

namespace gloam::reference {

inline dvec2 gloam_ndc_from_pixel(glm::ivec2 pixel, glm::ivec2 size) {
    if (size.x < 1 || size.y < 1) return dvec2(0.0);
    const auto axis = [](int p, int extent) { return (2.0 * p + 1.0 - double(extent)) / double(extent); };
    return dvec2(axis(pixel.x, size.x), axis(pixel.y, size.y));
}

inline dvec2 gloam_uv_from_ndc(dvec2 ndc) {
    if (!gloam_is_finite2(ndc)) return dvec2(2.0, 2.0);
    return 0.5 * ndc + 0.5;
}

inline dvec3 gloam_view_position_perspective(dvec2 ndc, double depth, dvec2 p00_p11) {
    const dvec3 none(0.0);
    if (gloam_is_background(depth)) return none;
    const dvec3 position(ndc.x / p00_p11.x * depth, ndc.y / p00_p11.y * depth, -depth);
    if (!gloam_is_finite3(position)) return none;
    return position;
}

inline dvec3 gloam_view_position_orthographic(dvec2 ndc, double depth, dvec2 p00_p11) {
    const dvec3 none(0.0);
    if (gloam_is_background(depth)) return none;
    const dvec3 position(ndc.x / p00_p11.x, ndc.y / p00_p11.y, -depth);
    if (!gloam_is_finite3(position)) return none;
    return position;
}

inline dvec2 gloam_ndc_perspective(dvec3 view_position, dvec2 p00_p11) {
    const dvec2 outside(2.0, 2.0);
    const double depth = -view_position.z;
    if (gloam_is_background(depth)) return outside;
    const dvec2 ndc(p00_p11.x * view_position.x / depth, p00_p11.y * view_position.y / depth);
    if (!gloam_is_finite2(ndc)) return outside;
    return ndc;
}

inline dvec2 gloam_ndc_orthographic(dvec3 view_position, dvec2 p00_p11) {
    const dvec2 outside(2.0, 2.0);
    if (gloam_is_background(-view_position.z)) return outside;
    const dvec2 ndc(p00_p11.x * view_position.x, p00_p11.y * view_position.y);
    if (!gloam_is_finite2(ndc)) return outside;
    return ndc;
}

}  // namespace gloam::reference
