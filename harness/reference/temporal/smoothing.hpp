// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_temporal_smooth(double history, bool valid, double current, double rate) {
    const bool has_history = valid && history >= 0.0 && history <= 1.0;
    const bool has_current = current >= 0.0 && current <= 1.0;
    if (!has_current) return has_history ? history : 0.0;
    if (!has_history || std::isnan(rate)) return current;
    return mix(history, current, gloam_unit_interval(rate));
}

}  // namespace gloam::reference
