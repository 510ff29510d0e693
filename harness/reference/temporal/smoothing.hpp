// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_temporal_smooth(T history, bool valid, T current, T rate) {
    const bool has_history = valid && history >= T(0) && history <= T(1);
    const bool has_current = current >= T(0) && current <= T(1);
    if (!has_current) return has_history ? gloam_unit_interval(history) : T(0);
    if (!has_history || !(rate < T(1))) return gloam_unit_interval(current);
    const T value = history + (current - history) * max(rate, T(0));
    return gloam_unit_interval(clamp(value, min(history, current), max(history, current)));
}

}  // namespace gloam::reference
