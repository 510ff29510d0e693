// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {
namespace detail {

template <class T>
T quarter_turn_angle() {
    return exact_number<T> ? pi<T>() / T(2) : T(1.570796327);
}

}  // namespace detail

template <class T>
T gloam_cone_angle_linear(T agreement) {
    return (T(1) - max(T(2) * gloam_unit_interval(agreement) - T(1), T(0))) * detail::quarter_turn_angle<T>();
}

template <class T>
T gloam_cone_angle(T agreement) {
    return gloam_acos(max(T(2) * gloam_unit_interval(agreement) - T(1), T(0)));
}

template <class T>
T gloam_cone_angle_uniform(T visibility) {
    return T(2) * gloam_asin(gloam_sqrt(T(0.5) * gloam_unit_interval(visibility)));
}

template <class T>
T gloam_cone_angle_cosine(T visibility) {
    const T v = gloam_unit_interval(visibility);
    if (v > T(0.5)) return detail::quarter_turn_angle<T>() - gloam_asin(gloam_sqrt(T(1) - v));
    return gloam_asin(gloam_sqrt(v));
}

}  // namespace gloam::reference
