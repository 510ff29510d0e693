// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/projected_radius.hpp"

namespace gloam::reference {

inline dvec2 gloam_radius_cap(dvec2 axes, double most) {
    const dvec2 reach = positive_lengths(axes);
    const double larger = max(reach.x, reach.y);
    const double cap = gloam_positive_length(most);
    return larger > cap ? reach * (cap / larger) : reach;
}

}  // namespace gloam::reference
