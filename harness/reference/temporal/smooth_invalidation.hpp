// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_invalidate_clamp(T weight, T weight_small) {
    if (!(weight > T(0) && weight_small > T(0))) return T(0);
    return weight < weight_small ? weight : weight_small;
}

template <class T>
T gloam_confidence(T change, T factor) {
    const T d = abs(change);
    if (!(d <= float_max<T>() && abs(factor) <= float_max<T>())) return T(0);
    const T x = factor > T(0) ? factor * d : T(0);
    return x <= T(0x1p126) ? min(T(1) / (T(1) + x), T(1)) : T(0);
}

template <class T>
T gloam_invalidate_confidence(T weight, T confidence) {
    if (!(weight > T(0) && weight <= float_max<T>())) return T(0);
    return weight * gloam_unit_interval(confidence);
}

}  // namespace gloam::reference
