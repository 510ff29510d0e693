// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

inline double gloam_sqrt(double x) {
    return x >= float_min ? sqrt(x) : 0.0;
}

}  // namespace gloam::reference
