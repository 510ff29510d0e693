// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/filter/gaussian.hpp"
#include "reference/filter/shrink.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/surface_position.hpp"
#include "reference/sampling/unit_interval.hpp"

// fetch_value: (occlusion, convergence) of a pixel inside the image.
namespace gloam::reference {

inline GloamWeightedMean gloam_filter_tap(GloamWeightedMean mean, dvec3 center, glm::ivec2 tap,
                                          double coverage, double scale, const Fetch<dvec2>& fetch_value,
                                          const Fetch<dvec3>& fetch_position) {
    const dvec3 position = fetch_position(tap);
    if (!gloam_is_surface_position(position)) return mean;
    const double near = gloam_gaussian_scaled(pow(distance(position, center), 2), scale);
    const dvec2 value = fetch_value(tap);
    return gloam_weighted_mean_add(mean, value.x, coverage * near * gloam_unit_interval(value.y));
}

// The sum of eq. 10 over every pixel of the row or column.
inline double gloam_convergence_filter(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width,
                                       double c_adaptive, double sigma, const Fetch<dvec2>& fetch_value,
                                       const Fetch<dvec3>& fetch_position) {
    const dvec2 own = fetch_value(pixel);
    const dvec3 center = fetch_position(pixel);
    const double reach = std::max(half_width, 0) * gloam_shrink(own.y, c_adaptive);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    for (int i = 0; i < std::max(size.x, size.y) && reach > 0.0 && gloam_is_surface_position(center); ++i) {
        const glm::ivec2 tap = pixel * (1 - axis) + i * axis;
        if (tap != min(tap, size - 1)) break;
        const int apart = std::max(std::abs(tap.x - pixel.x), std::abs(tap.y - pixel.y));
        const double coverage = std::clamp(reach - (apart - 1.0), 0.0, 1.0);
        mean = gloam_filter_tap(mean, center, tap, coverage, gloam_gaussian_scale(sigma), fetch_value,
                                fetch_position);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

}  // namespace gloam::reference
