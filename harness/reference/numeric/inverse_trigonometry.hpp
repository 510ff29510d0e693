// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/acos_approximation.hpp"

namespace gloam::reference {

inline double gloam_asin_half(double x) {
    return asin(x);
}

// |x|, at most 1; 0 for NaN.
inline double gloam_unit_magnitude(double x) {
    return abs(gloam_clamp_cosine(x));
}

// asin(m) for m up to 1/2, and from there the half of acos(m).
inline double gloam_small_arc(double m) {
    return m > 0.5 ? acos(m) / 2.0 : asin(m);
}

inline double gloam_acos(double x) {
    return acos(gloam_clamp_cosine(x));
}

inline double gloam_asin(double x) {
    return asin(gloam_clamp_cosine(x));
}

// The angle of the point (x, y), in (-pi, pi]; 0 for the origin and for NaN.
inline double gloam_atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return 0.0;
    if (std::max(abs(x), abs(y)) < float_min) return 0.0;
    return std::atan2(y + 0.0, x);  // the sign of a zero does not count
}

inline double gloam_atan(double x) {
    return std::isnan(x) ? 0.0 : atan(x);
}

}  // namespace gloam::reference
