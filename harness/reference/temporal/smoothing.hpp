// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_temporal_smooth(double history, bool valid, double current, double rate) {
    const bool has_history = valid && history >= 0.0 && history <= 1.0;
    const bool has_current = current >= 0.0 && current <= 1.0;
    if (!has_current) return has_history ? gloam_unit_interval(history) : 0.0;
    if (!has_history || !(rate < 1.0)) return gloam_unit_interval(current);
    const double value = history + (current - history) * max(rate, 0.0);
    return gloam_unit_interval(clamp(value, min(history, current), max(history, current)));
}

}  // namespace gloam::reference
