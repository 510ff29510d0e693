// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

// d / R inside the radius of influence; 1, which counts nothing, beyond it and for what is not a radius.
inline double falloff_ratio(double hit_distance, double radius) {
    const double d = abs(hit_distance);
    return d < radius && radius >= float_min ? d / radius : 1.0;
}

inline double gloam_falloff_step(double hit_distance, double radius) {
    return abs(hit_distance) <= radius ? 1.0 : 0.0;
}

inline double gloam_falloff_linear(double hit_distance, double radius) {
    return 1.0 - falloff_ratio(hit_distance, radius);
}

inline double gloam_falloff_quadratic(double hit_distance, double radius) {
    return 1.0 - pow(falloff_ratio(hit_distance, radius), 2);
}

inline double gloam_falloff_cubic(double hit_distance, double radius) {
    return 1.0 - pow(falloff_ratio(hit_distance, radius), 3);
}

inline double gloam_falloff_sao(double hit_distance, double radius) {
    return pow(1.0 - pow(falloff_ratio(hit_distance, radius), 2), 3);
}

inline double gloam_falloff_exponential(double hit_distance, double radius) {
    if (!is_finite(hit_distance) || !(radius >= float_min)) return 0.0;
    const double weight = exp(-abs(hit_distance) / radius);
    return weight >= 1.0 / 255.0 ? weight : 0.0;
}

inline double gloam_falloff_alchemy(double hit_distance, double u) {
    const double d = abs(hit_distance);
    return is_finite(d) && is_finite(u) && u >= float_min ? u * d / pow(max(u, d), 2) : 0.0;
}

inline double gloam_falloff_one(double hit_distance) {
    return std::isnan(hit_distance) ? 0.0 : 1.0;
}

inline double gloam_visibility_filion(double delta, double radius) {
    return delta >= float_min && radius >= float_min ? 1.0 - falloff_ratio(radius, delta) : 1.0;
}

}  // namespace gloam::reference
