// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_positive_length(double x) {
    return std::isnan(x) ? 0.0 : std::clamp(x, 0.0, float_max);
}

inline dvec2 positive_lengths(dvec2 axes) {
    return {gloam_positive_length(axes.x), gloam_positive_length(axes.y)};
}

inline dvec2 gloam_projected_radius_uv_orthographic(double radius, double depth, dvec2 p00_p11) {
    if (gloam_is_background(depth)) return dvec2(0.0);
    return positive_lengths(gloam_positive_length(radius) * abs(p00_p11) / 2.0);
}

inline dvec2 gloam_projected_radius_uv(double radius, double depth, dvec2 p00_p11) {
    if (gloam_is_background(depth)) return dvec2(0.0);
    return positive_lengths(gloam_positive_length(radius) * abs(p00_p11) / (2.0 * depth));
}

inline dvec2 gloam_projected_radius_pixels(double radius, double depth, dvec2 p00_p11, glm::ivec2 size) {
    return positive_lengths(gloam_projected_radius_uv(radius, depth, p00_p11) * dvec2(max(size, 0)));
}

inline dvec2 gloam_projected_radius_pixels_orthographic(double radius, double depth, dvec2 p00_p11,
                                                        glm::ivec2 size) {
    return positive_lengths(gloam_projected_radius_uv_orthographic(radius, depth, p00_p11) *
                            dvec2(max(size, 0)));
}

}  // namespace gloam::reference
