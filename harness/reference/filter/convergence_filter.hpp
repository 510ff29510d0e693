// SPDX-License-Identifier: MIT
#pragma once

#include "reference/filter/gaussian.hpp"
#include "reference/filter/shrink.hpp"
#include "reference/filter/weighted_mean.hpp"
#include "reference/geometry/surface_position.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

// fetch_value: vec2<T>(glm::ivec2), (occlusion, convergence); fetch_position: vec3<T>(glm::ivec2).
template <class T, class FetchValue, class FetchPosition>
GloamWeightedMean<T> gloam_filter_tap(GloamWeightedMean<T> mean, vec3<T> center, glm::ivec2 tap, T coverage,
                                      T sigma, FetchValue&& fetch_value, FetchPosition&& fetch_position) {
    const vec3<T> position = fetch_position(tap);
    if (!gloam_is_surface_position(position)) return mean;
    const vec2<T> value = fetch_value(tap);
    const vec3<T> offset = position - center;
    const T trust = gloam_unit_interval(value.y);
    return gloam_weighted_mean_add(mean, value.x,
                                   coverage * trust * gloam_gaussian(dot(offset, offset), sigma));
}

// The sum of the equation over every pixel of the row, its mean taken at once.
template <class T, class FetchValue, class FetchPosition>
T gloam_convergence_filter(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width, T c_adaptive,
                           T sigma, FetchValue&& fetch_value, FetchPosition&& fetch_position) {
    const vec2<T> own = fetch_value(pixel);
    const T unfiltered = gloam_unit_interval(own.x);
    const T reach = T(half_width > 0 ? half_width : 0) * gloam_shrink(own.y, c_adaptive);
    if (!(reach > T(0))) return unfiltered;
    const vec3<T> center = fetch_position(pixel);
    if (!gloam_is_surface_position(center)) return unfiltered;
    GloamWeightedMean<T> mean = gloam_weighted_mean_empty<T>();
    const int longest = max(size.x, size.y);
    for (int i = -longest; i <= longest; ++i) {
        const glm::ivec2 tap = pixel + i * axis;
        const bool inside = tap.x >= 0 && tap.x < size.x && tap.y >= 0 && tap.y < size.y;
        const T coverage = gloam_window_coverage(max(i, -i), reach);
        if (!inside || !(coverage > T(0))) continue;
        mean = gloam_filter_tap(mean, center, tap, coverage, sigma, fetch_value, fetch_position);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

}  // namespace gloam::reference
