// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_invalidate_clamp(T weight, T weight_small) {
    if (!(weight > T(0)) || !(weight_small > T(0))) return T(0);
    return min(weight, weight_small);
}

template <class T>
T gloam_confidence(T change, T factor) {
    if (!gloam_is_finite(change) || !gloam_is_finite(factor)) return T(0);
    if (!(factor > T(0))) return T(1);
    return T(1) / (T(1) + factor * abs(change));
}

template <class T>
T gloam_invalidate_confidence(T weight, T confidence) {
    if (!(weight > T(0)) || !gloam_is_finite(weight)) return T(0);
    return gloam_unit_interval(confidence) * weight;
}

}  // namespace gloam::reference
