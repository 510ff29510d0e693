// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec2 gloam_circle_point(double turn) {
    return on_circle(2.0 * pi * gloam_unit_interval(turn));
}

}  // namespace gloam::reference
