// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline dvec2 gloam_ndc_from_pixel(glm::ivec2 pixel, glm::ivec2 size) {
    if (size.x < 1 || size.y < 1) return dvec2(0.0);
    return 2.0 * (dvec2(pixel) + 0.5) / dvec2(size) - 1.0;
}

inline dvec2 gloam_uv_from_ndc(dvec2 ndc) {
    return is_finite(ndc) ? ndc / 2.0 + 0.5 : dvec2(2.0);
}

inline dvec3 gloam_view_position_perspective(dvec2 ndc, double depth, dvec2 p00_p11) {
    const dvec3 position = depth * dvec3(ndc / p00_p11, -1.0);
    return gloam_is_background(depth) || !is_finite(position) ? dvec3(0.0) : position;
}

inline dvec3 gloam_view_position_orthographic(dvec2 ndc, double depth, dvec2 p00_p11) {
    const dvec3 position(ndc / p00_p11, -depth);
    return gloam_is_background(depth) || !is_finite(position) ? dvec3(0.0) : position;
}

inline dvec2 gloam_ndc_perspective(dvec3 view_position, dvec2 p00_p11) {
    const double depth = -view_position.z;
    const dvec2 ndc = p00_p11 * dvec2(view_position) / depth;
    return gloam_is_background(depth) || !is_finite(ndc) ? dvec2(2.0) : ndc;
}

inline dvec2 gloam_ndc_orthographic(dvec3 view_position, dvec2 p00_p11) {
    const dvec2 ndc = p00_p11 * dvec2(view_position);
    return gloam_is_background(-view_position.z) || !is_finite(ndc) ? dvec2(2.0) : ndc;
}

}  // namespace gloam::reference
