// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/gaussian.hpp"
#include "reference/filter/shrink.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/surface_position.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

// fetch_value: dvec2(glm::ivec2), (occlusion, convergence); fetch_position: dvec3(glm::ivec2).
inline GloamWeightedMean gloam_filter_tap(GloamWeightedMean mean, dvec3 center, glm::ivec2 tap,
                                          double coverage, double scale, const Fetch<dvec2>& fetch_value,
                                          const Fetch<dvec3>& fetch_position) {
    const dvec3 position = fetch_position(tap);
    if (!gloam_is_surface_position(position)) return mean;
    const dvec2 value = fetch_value(tap);
    const dvec3 offset = position - center;
    const double weight =
        coverage * gloam_gaussian_scaled(dot(offset, offset), scale) * gloam_unit_interval(value.y);
    return gloam_weighted_mean_add(mean, value.x, weight);
}

inline double gloam_convergence_filter(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width,
                                       double c_adaptive, double sigma, const Fetch<dvec2>& fetch_value,
                                       const Fetch<dvec3>& fetch_position) {
    const dvec2 own = fetch_value(pixel);
    const double reach = double(max(half_width, 0)) * gloam_shrink(own.y, c_adaptive);
    if (!(reach > 0.0)) return gloam_unit_interval(own.x);
    const dvec3 center = fetch_position(pixel);
    if (!gloam_is_surface_position(center)) return gloam_unit_interval(own.x);
    const double scale = gloam_gaussian_scale(sigma);
    const auto add = [&](GloamWeightedMean mean, glm::ivec2 tap, double coverage) {
        return gloam_filter_tap(mean, center, tap, coverage, scale, fetch_value, fetch_position);
    };
    GloamWeightedMean mean = add(gloam_weighted_mean_empty(), pixel, 1.0);
    const int last = min(half_width, max(size.x, size.y));
    for (int i = 1; i <= last && double(i) < reach + 1.0; ++i) {
        const double coverage = gloam_window_coverage(i, reach);
        const glm::ivec2 before = pixel - i * axis;
        const glm::ivec2 after = pixel + i * axis;
        if (before.x >= 0 && before.y >= 0) mean = add(mean, before, coverage);
        if (after.x < size.x && after.y < size.y) mean = add(mean, after, coverage);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

}  // namespace gloam::reference
