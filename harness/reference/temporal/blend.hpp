// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_history_weight(T history, T weight, T weight_max) {
    const bool usable = history >= T(0) && history <= T(1);
    if (!usable || !(weight > T(0)) || !(weight_max > T(0))) return T(0);
    return min(weight, min(weight_max, float_max<T>()));
}

// The weighted mean as printed.
template <class T>
vec2<T> gloam_blend(T history, T weight, T contribution, T k, T weight_max) {
    const T w = gloam_history_weight(history, weight, weight_max);
    const T old = w > T(0) ? history : T(0);
    const bool samples = k > T(0) && gloam_is_finite(k) && gloam_is_finite(contribution);
    if (!samples) return vec2<T>(old, w);
    const T fresh = gloam_unit_interval(contribution);
    T most = T(0);
    if (weight_max > T(0)) most = min(weight_max, float_max<T>());
    return vec2<T>((w * old + k * fresh) / (w + k), min(w + k, most));
}

}  // namespace gloam::reference
