// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_history_weight(double history, double weight, double weight_max) {
    if (!(history > -float_min && history <= 1.0)) return 0.0;
    if (!(weight >= float_min && weight_max >= float_min)) return 0.0;
    const double cap = weight_max <= float_max ? weight_max : float_max;
    return weight < cap ? weight : cap;
}

inline dvec2 gloam_blend(double history, double weight, double contribution, double k, double weight_max) {
    const double w = gloam_history_weight(history, weight, weight_max);
    const double old = w > 0.0 && history >= float_min ? history : 0.0;
    if (!(k >= float_min && k <= float_max && abs(contribution) <= float_max)) return dvec2(old, w);
    const double fresh = gloam_unit_interval(contribution);
    const double cap = weight_max >= float_min ? min(weight_max, float_max) : 0.0;
    const double total = w + k;
    const double blended = w < k ? fresh + (old - fresh) * (w / total) : old + (fresh - old) * (k / total);
    return dvec2(blended, total < cap ? total : cap);
}

}  // namespace gloam::reference
