// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>

#include "reference/math.hpp"

// Angles, roots and bits.
namespace gloam::reference {

// 0 for NaN.
inline double cosine_in_range(double x) {
    return std::isnan(x) ? 0.0 : std::clamp(x, -1.0, 1.0);
}

// In degrees: 90 - 50 c - 40 c^3.
inline double gloam_acos_cubic(double x) {
    const double c = cosine_in_range(x);
    return pi / 180.0 * (90.0 - 50.0 * c - 40.0 * pow(c, 3));
}

inline double gloam_asin_half(double x) {
    return asin(x);
}

// |x|, at most 1; 0 for NaN.
inline double gloam_unit_magnitude(double x) {
    return abs(cosine_in_range(x));
}

// asin(m) for m up to 1/2, and from there the half of acos(m).
inline double gloam_small_arc(double m) {
    return m > 0.5 ? acos(m) / 2.0 : asin(m);
}

inline double gloam_acos(double x) {
    return acos(cosine_in_range(x));
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

// (cos, sin) of an angle in radians.
inline dvec2 on_circle(double angle) {
    return {cos(angle), sin(angle)};
}

// The direction of the rest, turned by 90 degrees as many times.
inline dvec2 gloam_sincos_octant(double rest, int quarters) {
    dvec2 v = on_circle(rest);
    for (int i = 0; i < (quarters & 3); ++i) v = dvec2(-v.y, v.x);
    return v;
}

inline dvec2 gloam_sincos_turns(double turns) {
    if (!std::isfinite(turns)) return {1.0, 0.0};
    return on_circle(2.0 * pi * std::remainder(turns, 1.0));
}

inline double gloam_turns(double angle) {
    return abs(angle) <= 65536.0 ? angle / (2.0 * pi) : 0.0;
}

inline dvec2 gloam_sincos(double angle) {
    return on_circle(abs(angle) <= 65536.0 ? angle : 0.0);
}

inline double gloam_sqrt(double x) {
    return x >= float_min ? sqrt(x) : 0.0;
}

inline double gloam_unit_angle(dvec2 direction) {
    return std::atan2(direction.y, direction.x);
}

// smaller / larger for 0 <= smaller <= larger; infinite lengths are equal.
inline double gloam_length_ratio(double smaller, double larger) {
    if (std::isinf(smaller)) return 1.0;
    return min(smaller / max(larger, float_min), 1.0);
}

inline unsigned gloam_bit_count(unsigned bits) {
    return static_cast<unsigned>(std::popcount(bits));
}

}  // namespace gloam::reference
