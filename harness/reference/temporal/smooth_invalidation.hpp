// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_invalidate_clamp(double weight, double weight_small) {
    return weight > 0.0 && weight_small > 0.0 ? min(weight, weight_small) : 0.0;
}

inline double gloam_confidence(double change, double factor) {
    if (!is_finite(change) || !is_finite(factor)) return 0.0;
    const double confidence = 1.0 / (1.0 + max(factor, 0.0) * abs(change));
    return confidence >= float_min ? confidence : 0.0;
}

inline double gloam_invalidate_confidence(double weight, double confidence) {
    return weight > 0.0 && is_finite(weight) ? weight * gloam_unit_interval(confidence) : 0.0;
}

}  // namespace gloam::reference
