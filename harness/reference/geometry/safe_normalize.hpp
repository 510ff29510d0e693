// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/finite.hpp"

namespace gloam::reference {

namespace detail {

// A power of two that takes components up to `largest` to where their squares neither over- nor underflow.
inline double squarable_scale(double largest) {
    if (largest > 4294967296.0) return 8.271806125530277e-25;
    return largest < 2.3283064365386963e-10 ? 1.2089258196146292e24 : 1.0;
}

}  // namespace detail

inline dvec3 gloam_safe_normalize(dvec3 v, dvec3 fallback) {
    if (!gloam_is_finite3(v)) return fallback;
    const double largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest >= float_min)) return fallback;
    const dvec3 scaled = v * detail::squarable_scale(largest);
    return scaled / sqrt(dot(scaled, scaled));
}

}  // namespace gloam::reference
