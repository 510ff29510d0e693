// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
vec3<T> gloam_ambient_light(vec3<T> incident, T occlusion) {
    return incident * (T(1) - gloam_unit_interval(occlusion));
}

}  // namespace gloam::reference
