// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_visibility(double occlusion) {
    return 1.0 - gloam_unit_interval(occlusion);
}

inline double gloam_visibility_clamp(double visibility) {
    return std::isnan(visibility) ? 1.0 : gloam_unit_interval(visibility);
}

}  // namespace gloam::reference
