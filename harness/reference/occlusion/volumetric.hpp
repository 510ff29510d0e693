// SPDX-License-Identifier: MIT
#pragma once

#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_chord_half_height(dvec2 xi, double radius) {
    const double squared = 1.0 - dot(xi, xi);
    return squared >= float_min && radius > 0.0 ? radius * sqrt(squared) : 0.0;
}

inline double gloam_line_ratio(double height, double half_height) {
    if (!(half_height >= float_min && half_height <= 0x1p126) || std::isnan(height)) return 0.5;
    return (half_height + height) / (2.0 * half_height);
}

inline double gloam_line_occlusion(double height, double half_height) {
    return gloam_unit_interval(gloam_line_ratio(height, half_height));
}

inline dvec2 gloam_line_pair(dvec2 ratios, double lowest, double highest) {
    const bool first = ratios.x >= lowest && ratios.x <= highest;
    const bool second = ratios.y >= lowest && ratios.y <= highest;
    if (!first && !second) return dvec2(0.5);
    return {first ? ratios.x : 1.0 - ratios.y, second ? ratios.y : 1.0 - ratios.x};
}

// The mean of the solid part over heights in [m - w, m + w], piece by piece: linear between the chord's ends.
inline double gloam_area_occlusion(double height, double half_width, double half_height) {
    if (!(half_width > 0.0)) return gloam_line_occlusion(height, half_height);
    if (!(half_height >= float_min && max(half_height, half_width) <= 0x1p126) || std::isnan(height))
        return 0.5;
    if (!is_finite(height) || half_width < 1e-9 * abs(height))
        return gloam_line_occlusion(height, half_height);
    const double low = height - half_width;
    const double high = height + half_width;
    const double ends[] = {low, clamp(-half_height, low, high), clamp(half_height, low, high), high};
    double integral = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double sum =
            gloam_line_occlusion(ends[i], half_height) + gloam_line_occlusion(ends[i + 1], half_height);
        integral += 0.5 * sum * (ends[i + 1] - ends[i]);
    }
    return integral / (high - low);
}

inline double gloam_two_balls(double fine, double broad) {
    const auto excess = [](double solid) { return is_finite(solid) ? solid - 0.5 : 0.0; };
    return gloam_unit_interval(0.5 + excess(fine) + excess(broad));
}

// Of the sphere of radius r / 2 around n r / 2.
inline double gloam_tangent_sphere_half_height(dvec3 offset, dvec3 normal, double radius) {
    if (!(radius >= float_min && radius <= 0x1p126)) return 0.0;
    return gloam_chord_half_height(dvec2(offset) / (radius / 2.0) - dvec2(normal), radius / 2.0);
}

inline double gloam_tangent_sphere_occlusion(dvec3 offset, dvec3 normal, double radius) {
    const double half_height = gloam_tangent_sphere_half_height(offset, normal, radius);
    const double height = offset.z - radius / 2.0 * normal.z;
    return half_height >= float_min && !std::isnan(height) ? gloam_line_occlusion(height, half_height) : 0.0;
}

}  // namespace gloam::reference
