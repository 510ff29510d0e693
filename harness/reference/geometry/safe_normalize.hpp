// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"

namespace gloam::reference {

inline dvec3 gloam_safe_normalize(dvec3 v, dvec3 fallback) {
    return has_direction(v) ? v / length(v) : fallback;
}

}  // namespace gloam::reference
