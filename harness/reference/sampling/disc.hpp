// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/square_root.hpp"
#include "reference/sampling/circle.hpp"

namespace gloam::reference {

inline dvec2 gloam_disc_sample(dvec2 zeta) {
    return gloam_sqrt(gloam_unit_interval(zeta.y)) * gloam_circle_point(zeta.x);
}

}  // namespace gloam::reference
