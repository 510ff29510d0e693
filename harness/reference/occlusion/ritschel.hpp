// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_contribution_ritschel(double blocked, double falloff, double cosine) {
    return gloam_unit_interval(blocked) * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

inline double gloam_contribution_cosine_directions(double blocked, double falloff) {
    return gloam_contribution_ritschel(blocked, falloff, 1.0);
}

inline double gloam_contribution_uniform_directions(double blocked, double falloff, double cosine) {
    return 2.0 * gloam_contribution_ritschel(blocked, falloff, cosine);
}

}  // namespace gloam::reference
