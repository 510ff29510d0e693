// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/background.hpp"

namespace gloam::reference {

inline double gloam_positive_length(double x) {
    return x > 0.0 ? (x <= float_max ? x : float_max) : 0.0;
}

namespace detail {

inline dvec2 positive_lengths(dvec2 axes) {
    return dvec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
}

inline dvec2 extent_of(glm::ivec2 size) {
    return dvec2(double(max(size.x, 0)), double(max(size.y, 0)));
}

}  // namespace detail

inline dvec2 gloam_projected_radius_uv(double radius, double depth, dvec2 p00_p11) {
    if (gloam_is_background(depth)) return dvec2(0.0);
    return detail::positive_lengths(dvec2(0.5 * abs(p00_p11) * (gloam_positive_length(radius) / depth)));
}

inline dvec2 gloam_projected_radius_pixels(double radius, double depth, dvec2 p00_p11, glm::ivec2 size) {
    return detail::positive_lengths(
        dvec2(gloam_projected_radius_uv(radius, depth, p00_p11) * detail::extent_of(size)));
}

inline dvec2 gloam_projected_radius_uv_orthographic(double radius, double depth, dvec2 p00_p11) {
    if (gloam_is_background(depth)) return dvec2(0.0);
    return detail::positive_lengths(dvec2(0.5 * abs(p00_p11) * gloam_positive_length(radius)));
}

inline dvec2 gloam_projected_radius_pixels_orthographic(double radius, double depth, dvec2 p00_p11,
                                                        glm::ivec2 size) {
    return detail::positive_lengths(
        dvec2(gloam_projected_radius_uv_orthographic(radius, depth, p00_p11) * detail::extent_of(size)));
}

}  // namespace gloam::reference
