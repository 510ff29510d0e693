// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/sincos.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec2 gloam_disc_sample(dvec2 zeta) {
    const double squared = gloam_unit_interval(zeta.y);
    return squared < float_min ? dvec2(0.0) : sqrt(squared) * gloam_sincos_turns(zeta.x);
}

}  // namespace gloam::reference
