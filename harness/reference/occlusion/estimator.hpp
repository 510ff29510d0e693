// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

template <class T>
vec2<T> gloam_estimator_add(vec2<T> accumulated, T contribution) {
    if (!gloam_is_finite(contribution)) return accumulated;
    return accumulated + vec2<T>(contribution, T(1));
}

template <class T>
T gloam_weighted_ratio(vec2<T> weighted) {
    if (!(weighted.y >= float_min<T>() && weighted.x > T(0))) return T(0);
    return weighted.x < weighted.y ? min(weighted.x / weighted.y, T(1)) : T(1);
}

template <class T>
T gloam_estimator_mean(vec2<T> accumulated) {
    if (!(accumulated.y >= T(1) && accumulated.x > T(0))) return T(0);
    return accumulated.x < accumulated.y ? min(accumulated.x / accumulated.y, T(1)) : T(1);
}

template <class T>
vec2<T> gloam_estimator_of_weighted(vec2<T> weighted, unsigned count) {
    return T(count) * vec2<T>(gloam_weighted_ratio(weighted), T(1));
}

}  // namespace gloam::reference
