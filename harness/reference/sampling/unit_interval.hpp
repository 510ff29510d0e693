// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_unit_interval(T x) {
    return x > T(0) ? (x < T(1) ? x : T(1)) : T(0);
}

}  // namespace gloam::reference
