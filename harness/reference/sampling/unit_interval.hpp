// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_unit_interval(double x) {
    return x > 0.0 ? (x < 1.0 ? x : 1.0) : 0.0;
}

}  // namespace gloam::reference
