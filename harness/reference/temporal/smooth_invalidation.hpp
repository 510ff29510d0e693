// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_invalidate_clamp(double weight, double weight_small) {
    if (!(weight > 0.0 && weight_small > 0.0)) return 0.0;
    return weight < weight_small ? weight : weight_small;
}

inline double gloam_confidence(double change, double factor) {
    const double d = abs(change);
    if (!(d <= float_max && abs(factor) <= float_max)) return 0.0;
    const double x = factor > 0.0 ? factor * d : 0.0;
    return x <= 0x1p126 ? min(1.0 / (1.0 + x), 1.0) : 0.0;
}

inline double gloam_invalidate_confidence(double weight, double confidence) {
    if (!(weight > 0.0 && weight <= float_max)) return 0.0;
    return weight * gloam_unit_interval(confidence);
}

}  // namespace gloam::reference
