// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec2 gloam_circle_point(double turn) {
    return gloam_sincos_turns(gloam_unit_interval(turn));
}

}  // namespace gloam::reference
