// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/projected_radius.hpp"
#include "reference/numeric/length_ratio.hpp"

namespace gloam::reference {

inline dvec2 gloam_radius_cap(dvec2 axes, double most) {
    const dvec2 reach = detail::positive_lengths(axes);
    const double larger = max(reach.x, reach.y);
    const double cap = gloam_positive_length(most);
    if (!(larger > cap)) return reach;
    return min(dvec2(reach * gloam_length_ratio(cap, larger)), dvec2(cap, cap));
}

}  // namespace gloam::reference
