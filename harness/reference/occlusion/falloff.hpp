// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {
namespace detail {

// A power of two that keeps differences of lengths of that size normal, and quotients where division is
// accurate.
inline double divisible_scale(double size) {
    if (size > 1.8446744e19) return 5.421010862427522e-20;
    return size < 5.421010862427522e-20 ? 1.8446744073709552e19 : 1.0;
}

}  // namespace detail

inline double gloam_falloff_step(double hit_distance, double radius) {
    return abs(hit_distance) <= radius ? 1.0 : 0.0;
}

inline double gloam_falloff_linear(double hit_distance, double radius) {
    const double d = abs(hit_distance);
    if (!(d < radius && radius >= float_min)) return 0.0;
    if (!(radius <= float_max)) return 1.0;
    const double scale = detail::divisible_scale(radius);
    const double r = radius * scale;
    return min((r - d * scale) / r, 1.0);
}

inline double gloam_falloff_quadratic(double hit_distance, double radius) {
    const double a = gloam_falloff_linear(hit_distance, radius);
    return min(a * (2.0 - a), 1.0);
}

inline double gloam_falloff_cubic(double hit_distance, double radius) {
    const double a = gloam_falloff_linear(hit_distance, radius);
    return min(a * (3.0 - a * (3.0 - a)), 1.0);
}

inline double gloam_falloff_sao(double hit_distance, double radius) {
    const double b = gloam_falloff_quadratic(hit_distance, radius);
    return b * b * b;
}

inline double gloam_falloff_exponential(double hit_distance, double radius) {
    const double d = abs(hit_distance);
    if (!(d <= float_max && radius >= float_min)) return 0.0;
    if (!(radius <= float_max)) return 1.0;
    const double scale = detail::divisible_scale(radius);
    const double r = radius * scale;
    const double scaled = d * scale;
    return scaled <= 5.541263545 * r ? min(exp(-(scaled / r)), 1.0) : 0.0;
}

inline double gloam_falloff_alchemy(double hit_distance, double u) {
    const double d = abs(hit_distance);
    if (!(d <= float_max && u >= float_min && u <= float_max)) return 0.0;
    const bool nearer = d < u;
    const double smaller = nearer ? d : u;
    const double larger = nearer ? u : d;
    const double scale = detail::divisible_scale(larger);
    return min(smaller * scale / (larger * scale), 1.0);
}

inline double gloam_falloff_one(double hit_distance) {
    return abs(hit_distance) >= 0.0 ? 1.0 : 0.0;
}

inline double gloam_visibility_filion(double delta, double radius) {
    if (!(delta >= float_min && radius >= float_min)) return 1.0;
    return gloam_falloff_linear(radius, delta);
}

}  // namespace gloam::reference
