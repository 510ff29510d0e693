// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_history_weight(T history, T weight, T weight_max) {
    if (!(history > -float_min<T>() && history <= T(1))) return T(0);
    if (!(weight >= float_min<T>() && weight_max >= float_min<T>())) return T(0);
    const T cap = weight_max <= float_max<T>() ? weight_max : float_max<T>();
    return weight < cap ? weight : cap;
}

template <class T>
vec2<T> gloam_blend(T history, T weight, T contribution, T k, T weight_max) {
    const T w = gloam_history_weight(history, weight, weight_max);
    const T old = w > T(0) && history >= float_min<T>() ? history : T(0);
    if (!(k >= float_min<T>() && k <= float_max<T>() && abs(contribution) <= float_max<T>()))
        return vec2<T>(old, w);
    const T fresh = gloam_unit_interval(contribution);
    const T cap = weight_max >= float_min<T>() ? min(weight_max, float_max<T>()) : T(0);
    const T total = w + k;
    const T blended = w < k ? fresh + (old - fresh) * (w / total) : old + (fresh - old) * (k / total);
    return vec2<T>(blended, total < cap ? total : cap);
}

}  // namespace gloam::reference
