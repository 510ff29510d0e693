// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline dvec3 gloam_ambient_light(dvec3 incident, double occlusion) {
    return (1.0 - gloam_unit_interval(occlusion)) * incident;
}

}  // namespace gloam::reference
