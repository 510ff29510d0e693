// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/projected_radius.hpp"
#include "reference/numeric/length_ratio.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_radius_cap(vec2<T> axes, T most) {
    const vec2<T> reach = detail::positive_lengths(axes);
    const T larger = max(reach.x, reach.y);
    const T cap = gloam_positive_length(most);
    if (!(larger > cap)) return reach;
    return min(vec2<T>(reach * gloam_length_ratio(cap, larger)), vec2<T>(cap, cap));
}

}  // namespace gloam::reference
