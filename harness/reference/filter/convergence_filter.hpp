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
                                      T scale, FetchValue&& fetch_value, FetchPosition&& fetch_position) {
    const vec3<T> position = fetch_position(tap);
    if (!gloam_is_surface_position(position)) return mean;
    const vec2<T> value = fetch_value(tap);
    const vec3<T> offset = position - center;
    const T weight =
        coverage * gloam_gaussian_scaled(dot(offset, offset), scale) * gloam_unit_interval(value.y);
    return gloam_weighted_mean_add(mean, value.x, weight);
}

template <class T, class FetchValue, class FetchPosition>
T gloam_convergence_filter(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width, T c_adaptive,
                           T sigma, FetchValue&& fetch_value, FetchPosition&& fetch_position) {
    const vec2<T> own = fetch_value(pixel);
    const T reach = T(max(half_width, 0)) * gloam_shrink(own.y, c_adaptive);
    if (!(reach > T(0))) return gloam_unit_interval(own.x);
    const vec3<T> center = fetch_position(pixel);
    if (!gloam_is_surface_position(center)) return gloam_unit_interval(own.x);
    const T scale = gloam_gaussian_scale(sigma);
    const auto add = [&](GloamWeightedMean<T> mean, glm::ivec2 tap, T coverage) {
        return gloam_filter_tap(mean, center, tap, coverage, scale, fetch_value, fetch_position);
    };
    GloamWeightedMean<T> mean = add(gloam_weighted_mean_empty<T>(), pixel, T(1));
    const int last = min(half_width, max(size.x, size.y));
    for (int i = 1; i <= last && T(i) < reach + T(1); ++i) {
        const T coverage = gloam_window_coverage(i, reach);
        const glm::ivec2 before = pixel - i * axis;
        const glm::ivec2 after = pixel + i * axis;
        if (before.x >= 0 && before.y >= 0) mean = add(mean, before, coverage);
        if (after.x < size.x && after.y < size.y) mean = add(mean, after, coverage);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

}  // namespace gloam::reference
