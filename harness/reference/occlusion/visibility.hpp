// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_visibility(T occlusion) {
    return occlusion > T(0) ? (occlusion < T(1) ? T(1) - occlusion : T(0)) : T(1);
}

template <class T>
T gloam_visibility_clamp(T visibility) {
    return visibility < T(1) ? (visibility > T(0) ? visibility : T(0)) : T(1);
}

}  // namespace gloam::reference
