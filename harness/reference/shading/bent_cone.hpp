// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {
namespace detail {

inline double quarter_turn_angle() {
    return pi / 2.0;
}

}  // namespace detail

inline double gloam_cone_angle_linear(double agreement) {
    return (1.0 - max(2.0 * gloam_unit_interval(agreement) - 1.0, 0.0)) * detail::quarter_turn_angle();
}

inline double gloam_cone_angle(double agreement) {
    return gloam_acos(max(2.0 * gloam_unit_interval(agreement) - 1.0, 0.0));
}

inline double gloam_cone_angle_uniform(double visibility) {
    return 2.0 * gloam_asin(gloam_sqrt(0.5 * gloam_unit_interval(visibility)));
}

inline double gloam_cone_angle_cosine(double visibility) {
    const double v = gloam_unit_interval(visibility);
    if (v > 0.5) return detail::quarter_turn_angle() - gloam_asin(gloam_sqrt(1.0 - v));
    return gloam_asin(gloam_sqrt(v));
}

}  // namespace gloam::reference
