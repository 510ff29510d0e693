// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_history_weight(double history, double weight, double weight_max) {
    const bool usable =
        history > -float_min && history <= 1.0 && weight >= float_min && weight_max >= float_min;
    return usable ? std::min({weight, weight_max, float_max}) : 0.0;
}

// (w AO + k C) / (w + k) and min(w + k, w_max).
inline dvec2 gloam_blend(double history, double weight, double contribution, double k, double weight_max) {
    const double w = gloam_history_weight(history, weight, weight_max);
    const double old = w > 0.0 && history >= float_min ? history : 0.0;
    if (!(k >= float_min && k <= float_max && is_finite(contribution))) return {old, w};
    const double most = weight_max >= float_min ? weight_max : 0.0;
    return {(w * old + k * gloam_unit_interval(contribution)) / (w + k), std::min({w + k, most, float_max})};
}

}  // namespace gloam::reference
